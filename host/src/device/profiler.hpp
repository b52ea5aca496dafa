// SPDX-License-Identifier: Apache-2.0
// Device times of launches and transfers. In: events with their human names, grouped by the step of the frame;
// out: milliseconds per name and per group, from the device's own clock, and a trace for those who want one.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <CL/opencl.hpp>
#include <cdsm/stats.hpp>

#include "device/command_trace.hpp"

namespace cdsm::device {

/// Used by one thread at a time, as its Device is. Events are read when a result is asked for, or once they are done.
class Profiler {
 public:
  /// What is recorded from here on counts to this group, e.g. "rasterize", "build maps", "render".
  void beginGroup(std::string group) { group_ = std::move(group); }
  const std::string& group() const { return group_; }

  /// Call it as soon as the command is enqueued.
  void record(const std::string& name, const cl::Event& event, const CommandSize& size = {});

  /// The queue keeps no times, whatever its events say: all are 0.
  void ignoreTimes() { ignoresTimes_ = true; }

  /// Where traced events go; empty: none are kept. Steps of the host go there at once.
  void setTrace(TraceSink sink) { sink_ = std::move(sink); }
  const TraceSink& trace() const { return sink_; }
  /// Sends the commands that have been recorded since the last time or reset(). Waits and throws as kernels() does.
  void flushTrace();

  /// Sums by name over all groups, in the order of the first record. Waits for what still runs; throws DeviceError
  /// for a launch that failed on the device.
  std::vector<KernelTime> kernels();
  /// Sum over what was recorded in the group; 0 for a group that never was. Waits and throws as kernels() does.
  double groupMilliseconds(const std::string& group);
  /// Of transfers from the host, which are called "upload ...". Waits and throws as kernels() does.
  std::uint64_t uploadedBytes();

  /// Bytes that were copied on the host since the last reset().
  void countCopy(std::uint64_t bytes) { copiedBytes_ += bytes; }
  std::uint64_t copiedBytes() const { return copiedBytes_; }

  /// Forgets all times; the current group stays.
  void reset();

 private:
  struct Pending {
    Enqueued command;
    cl::Event event;
  };
  struct Entry {
    std::string name;
    std::string group;
    double milliseconds = 0.0;
    std::uint64_t launches = 0;
    std::uint64_t bytes = 0;
  };

  void foldFinished();
  void foldAll();
  void foldFront();
  Entry& entry(const std::string& name, const std::string& group);

  bool ignoresTimes_ = false;
  std::string group_;
  TraceSink sink_;
  CommandTrace trace_;
  std::deque<Pending> pending_;
  std::vector<Entry> entries_;
  std::uint64_t copiedBytes_ = 0;
};

}  // namespace cdsm::device
