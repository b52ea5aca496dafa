// SPDX-License-Identifier: Apache-2.0
#include "build/map_pass.hpp"

#include "build/variant.hpp"
#include "cluster/light_camera.hpp"

namespace cdsm::build {

std::vector<shared::MapData> MapPass::run(const DeviceScene& scene, const std::vector<shared::ViewData>& views,
                                          float tolerance, RasterPass& raster, memory::MemoryStrategy& memory,
                                          const RasterPass::Report& report) {
  std::vector<shared::MapData> maps;
  for (const shared::ViewData& view : views) maps.push_back(cluster::mapData(view));
  memory.reserve(maps);
  BuildKernel buildVisibility(device_,
                              sceneProgram(device_, scene, "build/build_map.cl",
                                           {{"CDSM_MEMORY", '"' + std::string(memory.kernelFile()) + '"'}}),
                              "buildVisibility");
  for (std::size_t i = 0; i < views.size();) {
    device_.profiler().beginGroup("rasterize");
    Layers& layers = raster.run(scene, views[i], report);
    device_.profiler().beginGroup("build maps");
    const auto mapBuffer = device::Buffer<shared::MapData>::fromHost(device_, maps, "maps");
    const shared::BuildParams params{layers.view, tolerance, scene.interiorStep(), shared::uint(i), 0};
    memory.beginMap();
    const std::size_t pixels = std::size_t(layers.view.tilesX) * layers.view.tilesY * CDSM_TILE_PIXELS;
    buildVisibility({"build visibility functions", {pixels}, {CDSM_TILE_PIXELS}}, params, layers.fragments,
                    layers.ranges, mapBuffer, memory.params(), memory.writeArguments(),
                    scene.arguments(layers.initialObjects));
    std::string why;
    const memory::MapOutcome outcome = memory.finishMap(i, maps[i], why);
    if (outcome != memory::MapOutcome::Complete) report(why);
    if (outcome == memory::MapOutcome::BuildAllAgain) memory.reserve(maps);
    if (outcome == memory::MapOutcome::BuildAllAgain) i = 0;
    if (outcome == memory::MapOutcome::Complete) ++i;
  }
  memory.finish();
  return maps;
}

}  // namespace cdsm::build
