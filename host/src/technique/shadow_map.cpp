// SPDX-License-Identifier: Apache-2.0
#include "technique/shadow_map.hpp"

namespace cdsm::technique {

std::vector<shared::MapData> ShadowMap::buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                                  std::vector<MapCluster>&) {
  const float threshold = to.scene.shadows.threshold;
  const auto limits =
      device::Buffer<float>::fromHost(device(), to.deviceScene.opaqueExtinctions(threshold), "opaque extinctions");
  build::StopRule rule{"\"build/stop_opaque.clh\"", {}, {limits.cl()}};
  rule.params.threshold = threshold;
  std::vector<shared::MapData> maps = pass_.run(to.deviceScene, jobs, rule, to.raster, to.report);
  texels_.clear();
  for (const shared::MapData& map : maps) texels_.push_back(std::size_t(map.width) * std::size_t(map.height));
  return maps;
}

shared::TechniqueParams ShadowMap::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.bilinear = scene.shadows.filter == "bilinear";
  params.texelBias = texelBias(scene);
  params.pcf = scene.shadows.pcf;
  return params;
}

memory::NodeCounts ShadowMap::nodeCounts(std::size_t map) const { return {texels_[map], 1}; }

MemoryStats ShadowMap::memoryStats() const {
  MemoryStats stats;
  stats.strategy = "depth";
  stats.bytesReserved = stats.bytesUsed = pass_.depths().bytes();
  stats.bytesPerNode = sizeof(float);
  return stats;
}

}  // namespace cdsm::technique
