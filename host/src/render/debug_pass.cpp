// SPDX-License-Identifier: Apache-2.0
#include "render/debug_pass.hpp"

#include "render/shade_pass.hpp"

namespace cdsm::render {

std::vector<shared::MapProbe> DebugPass::probeMaps(const Scene& scene, const build::DeviceScene& deviceScene,
                                                   build::Layers& layers, std::size_t light,
                                                   const device::Buffer<shared::LightData>& lights,
                                                   const technique::ShadowTechnique& technique) {
  using Probes = device::Buffer<shared::MapProbe>;
  using ProbeKernel = device::Kernel<shared::ProbeParams, device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>,
                                     device::Buffer<shared::LightData>, Probes, shared::TechniqueParams,
                                     device::ArgumentList, device::ArgumentList>;
  const shared::ViewData& view = layers.view;
  const Probes probes(device_, std::size_t(view.width) * view.height, "probes of maps");
  const std::size_t items = std::size_t(view.tilesX) * view.tilesY * CDSM_TILE_PIXELS;
  const shared::ProbeParams params{view, deviceScene.allObjects().interiorStep, surfaceBias(scene, deviceScene),
                                   shared::uint(light), 0};
  ProbeKernel probeMaps(
      device_, build::sceneProgram(device_, deviceScene, "render/debug_view.cl", technique.kernelFiles()), "probeMaps");
  probeMaps({"probe maps", {items}, {CDSM_TILE_PIXELS}}, params, layers.fragments, layers.ranges, lights, probes,
            technique.params(scene), technique.arguments(),
            deviceScene.arguments(deviceScene.allObjects(), layers.initialObjects));
  return probes.download();
}

std::vector<std::uint32_t> layerCounts(const build::Layers& layers) {
  const shared::ViewData& view = layers.view;
  const std::vector<shared::uint2> ranges = layers.ranges.download();
  std::vector<std::uint32_t> counts;
  counts.reserve(std::size_t(view.width) * view.height);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const std::size_t tile = std::size_t(y / CDSM_TILE) * view.tilesX + x / CDSM_TILE;
      counts.push_back(ranges[tile * CDSM_TILE_PIXELS + (y % CDSM_TILE) * CDSM_TILE + x % CDSM_TILE].y);
    }
  return counts;
}

}  // namespace cdsm::render
