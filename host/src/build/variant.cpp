// SPDX-License-Identifier: Apache-2.0
#include "build/variant.hpp"

#include "memory/tile_strategy.hpp"

namespace cdsm::build {

Defines memoryDefines(const memory::MemoryStrategy& memory) {
  return {{"CDSM_MEMORY", '"' + std::string(memory.kernelFile()) + '"'}, memory::nodeFormatDefine(memory.format())};
}

device::ProgramSource sceneSource(const device::Device& device, const DeviceScene& scene, const std::string& entry,
                                  Defines parts) {
  // CPUs want vectors as wide as their registers, GPUs few registers per work item
  parts.emplace_back("CDSM_BATCH", device.isCpu() ? "8" : "4");
  parts.push_back(memory::spectrumDefine(scene.spectrum()));
  parts.emplace_back("CDSM_TILE_CHUNKS", std::to_string(memory::tileChunks(device, scene.spectrum())));
  parts.emplace_back("CDSM_SPHERES", scene.hasSpheres() ? "1" : "0");
  if (device.fetchImages()) parts.emplace_back("CDSM_FETCH_IMAGE", "1");
  return {entry, parts, {{"generated/volume_slots.clh", scene.slots().kernelFile()}}};
}

const cl::Program& sceneProgram(device::Device& device, const DeviceScene& scene, const std::string& entry,
                                Defines parts) {
  return device.programs().get(sceneSource(device, scene, entry, std::move(parts)));
}

}  // namespace cdsm::build
