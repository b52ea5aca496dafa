// SPDX-License-Identifier: Apache-2.0
// The engine for Python: works without the interpreter's lock, for one thread after the other.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <cdsm/cdsm.hpp>

#include "objects.hpp"

namespace cdsm::python {

class EngineObject {
 public:
  EngineObject(const std::string& device, const std::string& fetch, py::object progress, py::object warning);

  /// What `action(engine)` returns. It runs without the interpreter's lock, once no other thread uses the engine.
  template <class Action>
  auto work(Action action) {
    if (worker_ == std::this_thread::get_id())
      throw Error("the engine is used by its own callback, while it works; use it when the call has returned");
    const py::gil_scoped_release unlocked;
    const std::lock_guard<std::mutex> turn(mutex_);
    const Working working(worker_);
    return action(*engine_);
  }

  /// For Python's garbage collector: a callback may hold the engine.
  int visitCallbacks(visitproc visit, void* arg) const;
  void dropCallbacks();

 private:
  /// While it lives, this thread is the engine's.
  struct Working {
    explicit Working(std::atomic<std::thread::id>& worker) : worker(worker) { worker = std::this_thread::get_id(); }
    ~Working() { worker = std::thread::id(); }
    std::atomic<std::thread::id>& worker;
  };

  void tellProgress(const std::string& step, float done) const;
  void tellWarning(const std::string& text) const;

  py::object progress_, warning_;
  std::mutex mutex_;
  std::atomic<std::thread::id> worker_{};
  std::unique_ptr<Engine> engine_;  ///< goes first: nothing is told any more once the callbacks go
};

}  // namespace cdsm::python
