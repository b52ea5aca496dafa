// SPDX-License-Identifier: Apache-2.0
#include "technique/deep_shadow_map.hpp"

#include <utility>

#include "scene/range.hpp"
#include "technique/light_map.hpp"
#include "technique/memory_budget.hpp"

namespace cdsm::technique {

DeepShadowMap::DeepShadowMap(device::Device& device, MakeMemory makeMemory)
    : MapTechnique(device), makeMemory_(std::move(makeMemory)), memory_(makeMemory_()), pass_(device) {}

build::Defines DeepShadowMap::kernelFiles() const {
  build::Defines defines = build::memoryDefines(*memory_);
  defines.emplace_back("CDSM_TECHNIQUE", "\"technique/deep_shadow_map.clh\"");
  return defines;
}

std::vector<shared::MapData> DeepShadowMap::buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                                      std::vector<MapCluster>& clusters) {
  const float wanted = to.scene.shadows.tolerance, before = builtTolerance_;
  const MemoryBudget budget(to.scene.shadows);
  std::uint64_t texels = 0;
  for (const build::MapJob& job : jobs) texels += std::uint64_t(job.map.width) * job.map.height;
  budget.requireRoomFor(texels);
  std::vector<shared::MapData> built;
  const bool fresh = !maps().allocated();
  bool first = true;
  budget.fit([&](float tolerance) {
    // only what would fit without the frames before, too, may rest on them
    if (std::exchange(first, false) && (tolerance == builtTolerance_ || fresh)) {
      built = buildMapsAt(tolerance, to, jobs);
      const std::uint64_t bytes = memoryStats().bytesReserved;
      if (fresh || budget.fits(bytes)) return bytes;
    }
    built = buildAllAt(tolerance, to, jobs);
    return memoryStats().bytesReserved;
  });
  for (MapCluster& cluster : clusters)
    if (cluster.reason.empty() && (before != wanted || builtTolerance_ != wanted)) cluster.reason = "tolerance";
  return built;
}

std::vector<shared::MapData> DeepShadowMap::buildAllAt(float tolerance, const Preparation& to,
                                                       std::vector<build::MapJob> jobs) {
  for (build::MapJob& job : jobs) job.kept = memory::kBuildAnew;
  memory_.reset();
  memory_ = makeMemory_();
  return buildMapsAt(tolerance, to, jobs);
}

std::vector<shared::MapData> DeepShadowMap::buildMapsAt(float tolerance, const Preparation& to,
                                                        const std::vector<build::MapJob>& jobs) {
  const build::MapAccuracy accuracy{tolerance, to.scene.shadows.toleranceMode == "everywhere"};
  std::vector<shared::MapData> maps = pass_.run(to.deviceScene, jobs, accuracy, to.raster, *memory_, to.report);
  builtTolerance_ = tolerance;
  return maps;
}

shared::TechniqueParams DeepShadowMap::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.memory = memory_->params();
  params.bilinear = scene.shadows.filter == "bilinear";
  params.texelBias = texelBias(scene);
  return params;
}

device::ArgumentList DeepShadowMap::arguments() const {
  device::ArgumentList list{maps().cl()};
  for (const device::ArgumentList& part : {memory_->readArguments(), memory_->tileDepths().arguments()})
    list.insert(list.end(), part.begin(), part.end());
  return list;
}

MemoryStats DeepShadowMap::memoryStats() const {
  MemoryStats stats = memory_->stats();
  stats.bytesReserved += memory_->tileDepths().bytes();
  stats.bytesUsed += memory_->tileDepths().bytes();
  return stats;
}

std::vector<LightMap> DeepShadowMap::lightMaps(const Scene& scene, std::size_t light) const {
  const LightMaps& ofLight = mapsOf(light);
  std::vector<LightMap> maps;
  for (const MapCluster& cluster : *clusters()) {
    if (cluster.light != light) continue;
    for (std::size_t view = 0; view < cluster.views.size(); ++view) {
      maps.push_back(describeMap(scene, cluster, view));
      maps.back().tolerance = builtTolerance_;
      if (ofLight.formerCount > 0) maps.back().share = cluster.former ? 1.0f - ofLight.share : ofLight.share;
    }
  }
  return maps;
}

void DeepShadowMap::addStats(const Scene& scene, FrameStats& stats) const {
  MapTechnique::addStats(scene, stats);
  const MemoryBudget budget(scene.shadows);
  stats.memory.tolerance = builtTolerance_;
  stats.memory.limit = budget.limit();
  if (builtTolerance_ == scene.shadows.tolerance) return;
  stats.warnings.push_back("the maps were coarsened to shadows.tolerance = " + scene::formatNumber(builtTolerance_) +
                           " instead of " + scene::formatNumber(scene.shadows.tolerance) +
                           ", to fit in shadows.memory_limit_mb = " + scene::formatNumber(scene.shadows.memoryLimitMb));
  stats.reports.push_back(stats.warnings.back());
}

}  // namespace cdsm::technique
