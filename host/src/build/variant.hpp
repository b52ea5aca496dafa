// SPDX-License-Identifier: Apache-2.0
// Which variant of the kernels a device and a scene need.
#pragma once

#include <string>
#include <vector>

#include "build/device_scene.hpp"
#include "device/program.hpp"
#include "memory/memory_strategy.hpp"

namespace cdsm::build {

/// Defines of a ProgramSource: NAME, value; a value in quotes is a kernel file to include.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// CDSM_MEMORY and CDSM_NODE_FORMAT of maps in a strategy.
Defines memoryDefines(const memory::MemoryStrategy& memory);

/// The source of sceneProgram().
device::ProgramSource sceneSource(const device::Device& device, const DeviceScene& scene, const std::string& entry,
                                  Defines parts);

/// A kernel file of the scene's variant: the types of its volumes, how the device fetches, how wide its batches are,
/// whether it has spheres, what it follows of light. `parts`: memoryDefines(), CDSM_TECHNIQUE, CDSM_MARCH.
const cl::Program& sceneProgram(device::Device& device, const DeviceScene& scene, const std::string& entry,
                                Defines parts);

}  // namespace cdsm::build
