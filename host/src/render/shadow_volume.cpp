// SPDX-License-Identifier: Apache-2.0
#include "render/shadow_volume.hpp"

#include <algorithm>

#include "scene/changes.hpp"

namespace cdsm::render {

namespace {

constexpr std::size_t kRowsOfCell = CDSM_MACROCELL * CDSM_MACROCELL;
constexpr std::size_t kCellsOfLaunch = 2048;  ///< a million voxels, so that no launch keeps a display waiting
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
  // it is filled where something is to be seen, which transfer functions for shadows alone do not tell
  if (!before || !scene::sameTransmittance(*before, scene) || !scene::sameVisibility(*before, scene)) {
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
  const std::size_t voxels = deviceScene.spectrum().channels * deviceScene.shadowBlocks() * CDSM_SHADOW_BLOCK;
  voxels_ = {};
  voxels_ = device::Buffer<std::uint16_t>(device_, lightCount * voxels, "shadow volumes");
  voxels_.fill(std::uint16_t(CDSM_SHADOW_ONE));
  std::size_t done = 0, all = 0;
  for (const build::VolumeGrid& grid : deviceScene.volumeGrids()) all += lightCount * grid.cells;
  const device::Buffer<std::uint32_t> noObjects(device_, 0, "objects around the eye");
  const device::ArgumentList sceneArguments = deviceScene.arguments(deviceScene.allObjects(), noObjects);
  FillKernel fillShadowVolume(
      device_, build::sceneProgram(device_, deviceScene, "cache/fill_volume.cl", technique.kernelFiles()),
      "fillShadowVolume");
  for (std::size_t light = 0; light < lightCount; ++light) {
    for (const build::VolumeGrid& grid : deviceScene.volumeGrids()) {
      for (std::size_t first = 0; first < grid.cells; first += kCellsOfLaunch) {
        const std::size_t count = std::min<std::size_t>(grid.cells - first, kCellsOfLaunch);
        progress(kStep, float(double(done) / double(all)));
        fillShadowVolume({"fill shadow volume", {count * kRowsOfCell}, {kRowsOfCell}},
                         {grid.worldFromIndex, shared::uint(first), shared::uint(light), grid.medium, 0}, voxels_,
                         lights, params, technique.arguments(), sceneArguments);
        device_.finish();
        done += count;
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
