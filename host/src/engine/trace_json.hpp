// SPDX-License-Identifier: Apache-2.0
// A trace as JSON in the format of Chrome's trace viewer, which Perfetto reads, too (docs/tracing.md).
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::engine {

/// The file's text. Times are microseconds since `origin`, which no event may precede.
std::string traceJson(const DeviceDescription& device, const std::vector<TraceEvent>& events,
                      std::chrono::steady_clock::time_point origin);

}  // namespace cdsm::engine
