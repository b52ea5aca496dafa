// SPDX-License-Identifier: Apache-2.0
// Sums the device's own times. In: events; out: milliseconds per human name and per group.
#include "device/profiler.hpp"

#include <algorithm>
#include <string_view>

#include "device/cl_error.hpp"

namespace cdsm::device {
namespace {

constexpr std::size_t kPendingBeforeFolding = 256;  // bounds the events kept alive in a long run
constexpr std::string_view kUpload = "upload ";     // how names of transfers from the host begin
constexpr double kMillisecondsPerNanosecond = 1e-6;

/// Milliseconds from start to end; 0 where the device keeps no times.
double duration(const cl::Event& event) {
  try {
    const cl_ulong start = event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
    const cl_ulong end = event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
    return end > start ? static_cast<double>(end - start) * kMillisecondsPerNanosecond : 0.0;
  } catch (const cl::Error& error) {
    if (error.err() == CL_PROFILING_INFO_NOT_AVAILABLE) return 0.0;
    throw;
  }
}

bool hasFinished(const cl::Event& event) {
  return event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE;  // errors are negative
}

}  // namespace

void Profiler::record(const std::string& name, const cl::Event& event, const CommandSize& size) {
  Enqueued command{name, group_, size, std::chrono::steady_clock::now()};
  if (sink_) command.finished = guarded("launch of '" + name + "'", [&] { return hasFinished(event); });
  pending_.push_back({std::move(command), event});
  if (pending_.size() > kPendingBeforeFolding) foldFinished();
}

std::vector<KernelTime> Profiler::kernels() {
  foldAll();
  std::vector<KernelTime> times;
  for (const Entry& entry : entries_) {
    const auto known = std::find_if(times.begin(), times.end(), [&](const auto& t) { return t.name == entry.name; });
    KernelTime& time = known != times.end() ? *known : times.emplace_back(KernelTime{entry.name});
    time.milliseconds += entry.milliseconds;
    time.launches += entry.launches;
    time.bytes += entry.bytes;
  }
  return times;
}

std::uint64_t Profiler::uploadedBytes() {
  foldAll();
  std::uint64_t sum = 0;
  for (const Entry& entry : entries_)
    if (entry.name.compare(0, kUpload.size(), kUpload) == 0) sum += entry.bytes;
  return sum;
}

double Profiler::groupMilliseconds(const std::string& group) {
  foldAll();
  double sum = 0.0;
  for (const Entry& entry : entries_) {
    if (entry.group == group) sum += entry.milliseconds;
  }
  return sum;
}

void Profiler::flushTrace() {
  foldAll();
  trace_.sendTo(sink_);
}

void Profiler::reset() {
  trace_.clear();
  pending_.clear();
  entries_.clear();
  copiedBytes_ = 0;
}

void Profiler::foldFinished() {
  while (!pending_.empty()) {
    const Pending& front = pending_.front();
    if (!guarded("launch of '" + front.command.name + "'", [&] { return hasFinished(front.event); })) return;
    foldFront();
  }
}

void Profiler::foldAll() {
  while (!pending_.empty()) foldFront();
}

void Profiler::foldFront() {
  const Pending front = std::move(pending_.front());
  pending_.pop_front();  // before anything can throw: a failed launch is told once
  guarded("launch of '" + front.command.name + "'", [&] {
    front.event.wait();
    Entry& sum = entry(front.command.name, front.command.group);
    if (!ignoresTimes_) sum.milliseconds += duration(front.event);
    ++sum.launches;
    sum.bytes += front.command.size.bytes;
    if (sink_ && !ignoresTimes_) trace_.add(front.command, front.event);
  });
}

Profiler::Entry& Profiler::entry(const std::string& name, const std::string& group) {
  for (Entry& known : entries_) {
    if (known.name == name && known.group == group) return known;
  }
  return entries_.emplace_back(Entry{name, group});
}

}  // namespace cdsm::device
