// SPDX-License-Identifier: Apache-2.0
// STATS.json: what a run did, for programs to read. The keys are those of the user's contract, section 5.2.
#pragma once

#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::engine {

/// The file's text, indented, with a line break at its end: device, effective [shadows], and one entry per frame.
std::string statsJson(const DeviceDescription& device, const ShadowSettings& shadows,
                      const std::vector<FrameStats>& frames);

/// The devices as `cdsm devices --json` prints them: a list, one entry per device.
std::string devicesJson(const std::vector<DeviceDescription>& devices);

}  // namespace cdsm::engine
