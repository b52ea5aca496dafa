// SPDX-License-Identifier: Apache-2.0
#include "render/shadow_volume.hpp"

#include <algorithm>

#include "scene/changes.hpp"

namespace cdsm::render {

namespace {

constexpr std::uint32_t kVoxelsOfLaunch = 1u << 20;  ///< so that no launch keeps a display waiting
constexpr const char* kStep = "shadow volume";

}  // namespace

void ShadowVolume::prepare(const Scene& scene, const build::DeviceScene& deviceScene,
                           const device::Buffer<shared::LightData>& lights, const technique::ShadowTechnique& technique,
                           const Progress& progress) {
  const std::optional<Scene> before = std::exchange(filled_, std::nullopt);
  fresh_ = false;
  if (scene.shadows.cache == "none") {
    voxels_ = {};
    return;
  }
  if (!before || !scene::sameTransmittance(*before, scene)) {
    fill(deviceScene, scene.lights.size(), lights, technique, technique.params(scene), progress);
    fresh_ = true;
  }
  filled_ = scene;
}

void ShadowVolume::fill(const build::DeviceScene& deviceScene, std::size_t lightCount,
                        const device::Buffer<shared::LightData>& lights, const technique::ShadowTechnique& technique,
                        const shared::TechniqueParams& params, const Progress& progress) {
  using FillKernel =
      device::Kernel<shared::FillParams, device::Buffer<std::uint16_t>, device::Buffer<shared::LightData>,
                     shared::TechniqueParams, device::ArgumentList, device::ArgumentList>;
  const std::size_t blocks = deviceScene.shadowBlocks();
  voxels_ = {};
  voxels_ = device::Buffer<std::uint16_t>(device_, lightCount * blocks * CDSM_SHADOW_BLOCK, "shadow volumes");
  const device::Buffer<std::uint32_t> noObjects(device_, 0, "objects around the eye");
  const device::ArgumentList sceneArguments = deviceScene.arguments(deviceScene.allObjects(), noObjects);
  FillKernel fillShadowVolume(
      device_, build::sceneProgram(device_, deviceScene, "cache/fill_volume.cl", technique.kernelFiles()),
      "fillShadowVolume");
  for (std::size_t light = 0; light < lightCount; ++light) {
    for (const build::VolumeGrid& grid : deviceScene.volumeGrids()) {
      const shared::uint voxels = shared::uint(grid.size.x) * shared::uint(grid.size.y) * shared::uint(grid.size.z);
      for (shared::uint first = 0; first < voxels;) {
        const shared::uint count = std::min(voxels - first, kVoxelsOfLaunch);
        const float part = float(double(grid.firstBlock) + double(first) / CDSM_SHADOW_BLOCK) / float(blocks);
        progress(kStep, (float(light) + part) / float(lightCount));
        fillShadowVolume({"fill shadow volume", {count}, {64}},
                         {grid.worldFromIndex, grid.size, first, first + count,
                          shared::uint(light * blocks + grid.firstBlock), shared::uint(light)},
                         voxels_, lights, params, technique.arguments(), sceneArguments);
        device_.finish();
        first += count;
      }
    }
  }
}

build::Defines ShadowVolume::kernelFiles(const technique::ShadowTechnique& technique) const {
  build::Defines files = technique.kernelFiles();
  files.emplace_back("CDSM_CACHE", filled_ ? "\"cache/volume.clh\"" : "\"cache/none.clh\"");
  return files;
}

device::ArgumentList ShadowVolume::arguments(const technique::ShadowTechnique& technique) const {
  device::ArgumentList list = technique.arguments();
  if (filled_) list.push_back(voxels_.cl());
  return list;
}

std::optional<CacheStats> ShadowVolume::stats() const {
  if (!filled_) return std::nullopt;
  return CacheStats{voxels_.bytes(), fresh_};
}

}  // namespace cdsm::render
