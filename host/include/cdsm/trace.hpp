// SPDX-License-Identifier: Apache-2.0
// What happened when: steps of the host, and commands of the device on the host's clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace cdsm {

struct TraceEvent {
  enum class Track { Host, Device };

  Track track = Track::Host;
  std::string name;                             ///< human name of the step, launch or transfer
  std::string group;                            ///< device: step of the frame that the command counts to
  std::chrono::steady_clock::time_point begin;  ///< device: right to a few microseconds (docs/tracing.md)
  std::chrono::nanoseconds duration{0};
  std::uint64_t bytes = 0;      ///< of a transfer or fill
  std::uint64_t workItems = 0;  ///< of a kernel, before rounding up to whole groups
};

/// Gets each event once, on the thread that called the engine, while that call lasts; not in the order of time. Steps
/// of the host may lie within each other. An exception that it throws is dropped, and the event with it.
using TraceSink = std::function<void(const TraceEvent&)>;

}  // namespace cdsm
