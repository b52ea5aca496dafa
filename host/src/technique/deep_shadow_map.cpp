// SPDX-License-Identifier: Apache-2.0
#include "technique/deep_shadow_map.hpp"

namespace cdsm::technique {

DeepShadowMap::DeepShadowMap(device::Device& device, std::unique_ptr<memory::MemoryStrategy> memory)
    : MapTechnique(device), memory_(std::move(memory)), pass_(device) {}

build::Defines DeepShadowMap::kernelFiles() const {
  return {{"CDSM_TECHNIQUE", "\"technique/deep_shadow_map.clh\""},
          {"CDSM_MEMORY", '"' + std::string(memory_->kernelFile()) + '"'}};
}

std::vector<shared::MapData> DeepShadowMap::buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs) {
  return pass_.run(to.deviceScene, jobs, to.scene.shadows.tolerance, to.raster, *memory_, to.report);
}

shared::TechniqueParams DeepShadowMap::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.memory = memory_->params();
  params.bilinear = scene.shadows.filter == "bilinear";
  return params;
}

device::ArgumentList DeepShadowMap::arguments() const {
  device::ArgumentList list{maps().cl()};
  const device::ArgumentList nodes = memory_->readArguments();
  list.insert(list.end(), nodes.begin(), nodes.end());
  return list;
}

}  // namespace cdsm::technique
