// SPDX-License-Identifier: Apache-2.0
#include "technique/implicit_sphere.hpp"

namespace cdsm::technique {

namespace {

/// Texels around its centre that a sphere covers at least: a circle of half the diagonal of a texel holds the middle of
/// one, wherever it lies.
constexpr float kLeastRadius = 0.71f;

}  // namespace

std::vector<shared::MapData> ImplicitSphere::buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                                       std::vector<MapCluster>&) {
  build::StopRule rule{"\"build/stop_sphere.clh\"", {}, {}, kLeastRadius};
  rule.params.threshold = to.scene.shadows.threshold;
  std::vector<shared::MapData> maps = pass_.run(to.deviceScene, jobs, rule, to.raster, to.report);
  texels_.clear();
  for (const shared::MapData& map : maps) texels_.push_back(std::size_t(map.width) * std::size_t(map.height));
  return maps;
}

shared::TechniqueParams ImplicitSphere::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.patch = scene.shadows.patch;
  params.softness = scene.shadows.softness;
  params.softnessDistance = scene.shadows.softnessDistance;
  params.softnessExponent = scene.shadows.softnessExponent;
  return params;
}

memory::NodeCounts ImplicitSphere::nodeCounts(std::size_t map) const { return {texels_[map], 1}; }

MemoryStats ImplicitSphere::memoryStats() const {
  MemoryStats stats;
  stats.strategy = "sphere";
  stats.bytesReserved = stats.bytesUsed = pass_.depths().bytes();
  stats.bytesPerNode = kFloats * sizeof(float);
  return stats;
}

}  // namespace cdsm::technique
