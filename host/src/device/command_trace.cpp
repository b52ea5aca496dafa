// SPDX-License-Identifier: Apache-2.0
#include "device/command_trace.hpp"

#include <algorithm>
#include <limits>

#include "device/host_step.hpp"

namespace cdsm::device {

namespace {

using std::chrono::duration_cast;
using std::chrono::nanoseconds;
using std::chrono::steady_clock;

/// A time of the device in nanoseconds; 0 where it keeps none.
std::int64_t timeOf(const cl::Event& event, cl_profiling_info which) {
  cl_ulong time = 0;
  const cl_int code = clGetEventProfilingInfo(event(), which, sizeof time, &time, nullptr);
  return code == CL_SUCCESS ? std::int64_t(time) : 0;
}

}  // namespace

void sendTo(const TraceSink& sink, const TraceEvent& event) noexcept {
  if (!sink) return;
  try {
    sink(event);
  } catch (...) {  // a trace must not stop the work that it watches
  }
}

void CommandTrace::add(const Enqueued& command, const cl::Event& event) {
  const std::int64_t queued = timeOf(event, CL_PROFILING_COMMAND_QUEUED);
  const std::int64_t start = timeOf(event, CL_PROFILING_COMMAND_START);
  const std::int64_t end = timeOf(event, CL_PROFILING_COMMAND_END);
  if (queued <= 0 || start < queued || end < start) return;
  const std::int64_t by = duration_cast<nanoseconds>(command.by.time_since_epoch()).count();
  TraceEvent traced;
  traced.track = TraceEvent::Track::Device;
  traced.name = command.name;
  traced.group = command.group;
  traced.duration = nanoseconds(end - start);
  traced.bytes = command.size.bytes;
  traced.workItems = command.size.workItems;
  commands_.push_back({std::move(traced), start, by - (command.finished ? end : queued)});
}

void CommandTrace::sendTo(const TraceSink& sink) {
  std::int64_t offset = std::numeric_limits<std::int64_t>::max();
  for (const Command& command : commands_) offset = std::min(offset, command.offset);
  for (Command& command : commands_) {
    command.event.begin =
        steady_clock::time_point(duration_cast<steady_clock::duration>(nanoseconds(command.start + offset)));
    device::sendTo(sink, command.event);
  }
  commands_.clear();
}

}  // namespace cdsm::device
