// SPDX-License-Identifier: Apache-2.0
// A step of the host in a trace: from construction to destruction.
#pragma once

#include <string>
#include <utility>

#include <cdsm/trace.hpp>

namespace cdsm::device {

/// Hands an event to the sink and drops what it throws.
void sendTo(const TraceSink& sink, const TraceEvent& event) noexcept;

/// Costs nothing to speak of without a sink.
class HostStep {
 public:
  /// `sink` may be empty and must live until the step ends.
  HostStep(const TraceSink& sink, std::string name) : sink_(sink) {
    if (sink_) event_.name = std::move(name);
    event_.begin = std::chrono::steady_clock::now();
  }
  ~HostStep() {
    event_.duration = std::chrono::steady_clock::now() - event_.begin;
    sendTo(sink_, event_);
  }
  HostStep(const HostStep&) = delete;
  HostStep& operator=(const HostStep&) = delete;

 private:
  const TraceSink& sink_;
  TraceEvent event_;
};

}  // namespace cdsm::device
