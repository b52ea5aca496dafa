// SPDX-License-Identifier: Apache-2.0
#include "build/map_pass.hpp"

#include "build/variant.hpp"
#include "device/host_step.hpp"

namespace cdsm::build {

namespace {

const char* marchFile(const MapAccuracy& accuracy) {
  return accuracy.everywhere ? "\"build/march_everywhere.clh\"" : "\"build/march_samples.clh\"";
}

}  // namespace

std::vector<shared::MapData> MapPass::run(const DeviceScene& scene, const std::vector<MapJob>& jobs,
                                          const MapAccuracy& accuracy, RasterPass& raster,
                                          memory::MemoryStrategy& memory, const RasterPass::Report& report) {
  std::vector<shared::MapData> maps;
  std::vector<int> kept;
  for (const MapJob& job : jobs) {
    maps.push_back(job.map);
    kept.push_back(job.kept);
  }
  memory.reserve(maps, kept);
  memory.tileDepths().reserve(maps, kept);
  Defines parts = memoryDefines(memory);
  parts.emplace_back("CDSM_MARCH", marchFile(accuracy));
  BuildKernel buildVisibility(device_, sceneProgram(device_, scene, "build/build_map.cl", parts), "buildVisibility");
  const float tolerance = memory.format().compressionTolerance(accuracy.tolerance);
  const ExtinctionCurves curves(device_, accuracy.everywhere ? scene.curves() : std::vector<ExtinctionCurve>());
  const device::ArgumentList marchArguments = accuracy.everywhere ? curves.arguments() : device::ArgumentList();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (kept[i] != memory::kBuildAnew) continue;
    const device::HostStep step(device_.profiler().trace(), "build map " + std::to_string(i));
    const ObjectSet& casters = scene.castingObjects(jobs[i].casters);
    for (bool complete = false; !complete;) {
      device_.profiler().beginGroup("rasterize");
      Layers& layers = raster.run(scene, casters, jobs[i].view, report);
      device_.profiler().beginGroup("build maps");
      const auto mapBuffer = device::Buffer<shared::MapData>::fromHost(device_, maps, "maps");
      const shared::BuildParams params{layers.view, tolerance, casters.interiorStep, shared::uint(i), 0};
      memory.beginMap();
      const std::size_t pixels = std::size_t(layers.view.tilesX) * layers.view.tilesY * CDSM_TILE_PIXELS;
      buildVisibility({"build visibility functions", {pixels}, {CDSM_TILE_PIXELS}}, params, layers.fragments,
                      layers.ranges, mapBuffer, memory.params(), memory.writeArguments(),
                      scene.arguments(casters, layers.initialObjects), marchArguments, memory.tileDepths().arguments());
      std::string why;
      complete = memory.finishMap(i, maps, why);
      if (!complete) report(why);
    }
  }
  memory.finish();
  return maps;
}

}  // namespace cdsm::build
