// SPDX-License-Identifier: Apache-2.0
#include "technique/depth_technique.hpp"

namespace cdsm::technique {

std::vector<shared::MapData> DepthTechnique::buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                                       std::vector<MapCluster>&) {
  std::vector<shared::MapData> maps = pass_.run(to.deviceScene, jobs, stopRule(to), to.raster, to.report);
  texels_.clear();
  for (const shared::MapData& map : maps) texels_.push_back(std::size_t(map.width) * std::size_t(map.height));
  return maps;
}

memory::NodeCounts DepthTechnique::nodeCounts(std::size_t map) const {
  return {texel_.nodes * texels_[map], texel_.nodes};
}

MemoryStats DepthTechnique::memoryStats() const {
  MemoryStats stats;
  stats.strategy = texel_.strategy;
  stats.bytesReserved = stats.bytesUsed = pass_.depths().bytes();
  stats.bytesPerNode = double(texel_.floatsPerNode * sizeof(float));
  return stats;
}

}  // namespace cdsm::technique
