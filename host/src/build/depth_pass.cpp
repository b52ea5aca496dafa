// SPDX-License-Identifier: Apache-2.0
#include "build/depth_pass.hpp"

#include "build/variant.hpp"
#include "device/copy.hpp"

namespace cdsm::build {

namespace {

std::size_t texelsOf(const shared::MapData& map) { return std::size_t(map.width) * std::size_t(map.height); }

/// Each set of casters draws numbers of its own: its map may be multiplied with those of others.
std::uint32_t seedOf(std::uint32_t seed, const std::vector<unsigned>& casters) {
  for (const unsigned object : casters) seed = (seed ^ (object + 1)) * 16777619u;
  return seed;
}

}  // namespace

std::vector<shared::MapData> DepthPass::place(const std::vector<MapJob>& jobs) {
  std::vector<shared::MapData> maps;
  std::size_t texels = 0;
  bool none = true, inPlace = true;
  for (const MapJob& job : jobs) {
    maps.push_back(job.map);
    maps.back().firstTexel = shared::uint(texels);
    none = none && job.kept == memory::kBuildAnew;
    inPlace = inPlace && (job.kept == memory::kBuildAnew || job.map.firstTexel == texels);
    texels += texelsOf(job.map);
  }
  if (texels > 0xffffffffu)
    throw DeviceError("the shadow maps have " + std::to_string(texels) +
                      " texels, must be below 2^32; take a smaller map_size or fewer clusters");
  const std::size_t size = depthsPerTexel_ * texels + readBeyond_;
  if (inPlace && depths_.size() == size) return maps;
  if (none) depths_ = {};
  Floats moved(device_, size, "depths of shadow maps");
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (jobs[i].kept != memory::kBuildAnew)
      device::copyElements(device_, depths_, depthsPerTexel_ * jobs[i].map.firstTexel,
                           depthsPerTexel_ * texelsOf(maps[i]), moved, depthsPerTexel_ * maps[i].firstTexel);
  depths_ = std::move(moved);
  return maps;
}

std::vector<shared::MapData> DepthPass::run(const DeviceScene& scene, const std::vector<MapJob>& jobs,
                                            const StopRule& rule, RasterPass& raster,
                                            const RasterPass::Report& report) {
  std::vector<shared::MapData> maps = place(jobs);
  DepthKernel buildDepths(
      device_, sceneProgram(device_, scene, "build/build_depth.cl", {{"CDSM_STOP", rule.kernelFile}}), "buildDepths");
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (jobs[i].kept != memory::kBuildAnew) continue;
    const ObjectSet& casters = scene.castingObjects(jobs[i].casters);
    device_.profiler().beginGroup("rasterize");
    const Layers& layers = raster.run(scene, casters, jobs[i].view, report, rule.leastRadius);
    device_.profiler().beginGroup("build maps");
    shared::DepthParams params = rule.params;
    params.view = layers.view;
    params.firstTexel = maps[i].firstTexel;
    params.seed = seedOf(rule.params.seed, jobs[i].casters);
    const std::size_t pixels = std::size_t(layers.view.tilesX) * layers.view.tilesY * CDSM_TILE_PIXELS;
    buildDepths({"build depths", {pixels}, {CDSM_TILE_PIXELS}}, params, layers.fragments, layers.ranges, depths_,
                scene.arguments(casters, layers.initialObjects), rule.arguments);
  }
  return maps;
}

}  // namespace cdsm::build
