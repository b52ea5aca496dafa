// SPDX-License-Identifier: Apache-2.0
// What the kernel tests share: devices (opened on first use, closed before the program ends), kernels around a device
// function, scenes on the device.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <cdsm/scene.hpp>

#include "build/device_scene.hpp"
#include "device/device.hpp"
#include "device/kernel.hpp"
#include "device/program.hpp"

namespace cdsm::kernels {

/// The device at hand (CDSM_DEVICE, else the first usable), fetching volumes as "buffer" or "image".
device::Device& deviceOf(const std::string& fetch = "buffer");
/// False for "image" where the device has none.
bool canFetch(const std::string& fetch);

using Defines = std::vector<std::pair<std::string, std::string>>;

/// A program of the test's own text, which may include kernel files and the `generated` ones.
const cl::Program& testProgram(device::Device& device, const std::string& text, const Defines& defines = {},
                               const std::map<std::string, std::string>& generated = {});

/// The same for a scene: its volume slots, the fetch of its device and CDSM_BATCH are set, as the engine sets them.
const cl::Program& sceneTestProgram(device::Device& device, const build::DeviceScene& scene, const std::string& text);

/// Groups of this many items for tests that need no certain size.
constexpr std::size_t kGroup = 16;

}  // namespace cdsm::kernels
