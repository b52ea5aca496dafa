// SPDX-License-Identifier: Apache-2.0
// The unit of the benchmarks: how many trilinear samples the device takes in a second.
#pragma once

#include <string>

namespace cdsm::engine {

/// Million trilinear samples per second of a 256^3 float volume in a buffer, 512^2 rays of 256 steps; the median of
/// `runs` (odd), by the device's own clock. `device` as EngineOptions::device.
double trilinearRate(const std::string& device, int runs);

}  // namespace cdsm::engine
