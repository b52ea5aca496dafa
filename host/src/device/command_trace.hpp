// SPDX-License-Identifier: Apache-2.0
// Commands of a queue -> trace events on the host's clock. In: finished events and when the host had enqueued them;
// out: TraceEvents.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include <CL/opencl.hpp>
#include <cdsm/trace.hpp>

namespace cdsm::device {

/// What a command moves or computes.
struct CommandSize {
  std::uint64_t bytes = 0;
  std::uint64_t workItems = 0;
};

/// What the host knows of a command once it is enqueued.
struct Enqueued {
  std::string name;
  std::string group;
  CommandSize size;
  std::chrono::steady_clock::time_point by;  ///< enqueued no later than this
  bool finished = false;                     ///< by then; so blocking transfers are
};

/// The two clocks are compared anew for each batch: the offset of the host's clock is the largest one for which no
/// command has been queued, or has ended where the host had waited for it, later than the host says. So commands seem a
/// little late, by the shortest time in which the host has ever heard of one, but never outside of the step that
/// waited.
class CommandTrace {
 public:
  /// `event` must have ended. Without times of the device it is left out.
  void add(const Enqueued& command, const cl::Event& event);
  /// Hands out the batch and begins another one.
  void sendTo(const TraceSink& sink);
  void clear() { commands_.clear(); }

 private:
  struct Command {
    TraceEvent event;
    std::int64_t start;   ///< nanoseconds of the device's clock
    std::int64_t offset;  ///< upper bound of (host's clock - device's clock), nanoseconds
  };
  std::vector<Command> commands_;
};

}  // namespace cdsm::device
