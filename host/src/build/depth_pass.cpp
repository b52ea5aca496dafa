// SPDX-License-Identifier: Apache-2.0
#include "build/depth_pass.hpp"

#include "build/variant.hpp"
#include "device/copy.hpp"

namespace cdsm::build {

namespace {

std::size_t texelsOf(const shared::MapData& map) { return std::size_t(map.width) * std::size_t(map.height); }

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
  if (inPlace && depths_.size() == texels) return maps;
  if (none) depths_ = {};
  Floats moved(device_, texels, "depths of shadow maps");
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (jobs[i].kept != memory::kBuildAnew)
      device::copyElements(device_, depths_, jobs[i].map.firstTexel, texelsOf(maps[i]), moved, maps[i].firstTexel);
  depths_ = std::move(moved);
  return maps;
}

std::vector<shared::MapData> DepthPass::run(const DeviceScene& scene, const std::vector<MapJob>& jobs, float threshold,
                                            RasterPass& raster, const RasterPass::Report& report) {
  std::vector<shared::MapData> maps = place(jobs);
  const auto limits = Floats::fromHost(device_, scene.opaqueExtinctions(threshold), "opaque extinctions");
  DepthKernel buildDepths(device_, sceneProgram(device_, scene, "build/build_depth.cl", {}), "buildDepths");
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (jobs[i].kept != memory::kBuildAnew) continue;
    const ObjectSet& casters = scene.castingObjects(jobs[i].casters);
    device_.profiler().beginGroup("rasterize");
    const Layers& layers = raster.run(scene, casters, jobs[i].view, report);
    device_.profiler().beginGroup("build maps");
    const shared::DepthParams params{layers.view, threshold, maps[i].firstTexel, 0, 0};
    const std::size_t pixels = std::size_t(layers.view.tilesX) * layers.view.tilesY * CDSM_TILE_PIXELS;
    buildDepths({"build depths", {pixels}, {CDSM_TILE_PIXELS}}, params, layers.fragments, layers.ranges, limits,
                depths_, scene.arguments(casters, layers.initialObjects));
  }
  return maps;
}

}  // namespace cdsm::build
