// SPDX-License-Identifier: Apache-2.0
// Which variant of the kernels a device and a scene need.
#pragma once

#include <string>
#include <vector>

#include "build/device_scene.hpp"
#include "device/program.hpp"

namespace cdsm::build {

/// Defines of a ProgramSource: NAME, value; a value in quotes is a kernel file to include.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// The source of sceneProgram().
device::ProgramSource sceneSource(const device::Device& device, const DeviceScene& scene, const std::string& entry,
                                  Defines parts);

/// A kernel file of the scene's variant: the types of its volumes, how the device fetches, how wide its batches are.
/// `parts`: CDSM_MEMORY, CDSM_TECHNIQUE.
const cl::Program& sceneProgram(device::Device& device, const DeviceScene& scene, const std::string& entry,
                                Defines parts);

}  // namespace cdsm::build
