// SPDX-License-Identifier: Apache-2.0
#include "technique/deep_shadow_map.hpp"

#include <algorithm>

#include "cluster/light_camera.hpp"

namespace cdsm::technique {

namespace {

/// Depth of the farthest corner of the bounds; the near plane's where all of them lie in front of it.
float farthestDepth(const shared::ViewData& view, const scene::Bounds& bounds) {
  const glm::vec3 axis(view.depth.x, view.depth.y, view.depth.z);
  const glm::vec3 corner = glm::mix(bounds.low, bounds.high, glm::vec3(glm::greaterThan(axis, glm::vec3(0.0f))));
  return std::max(glm::dot(axis, corner) + view.depth.w, view.nearDepth);
}

}  // namespace

DeepShadowMap::DeepShadowMap(device::Device& device, std::unique_ptr<memory::MemoryStrategy> memory)
    : device_(device), memory_(std::move(memory)), pass_(device) {}

build::Defines DeepShadowMap::kernelFiles() const {
  return {{"CDSM_TECHNIQUE", "\"technique/deep_shadow_map.clh\""},
          {"CDSM_MEMORY", '"' + std::string(memory_->kernelFile()) + '"'}};
}

void DeepShadowMap::prepare(const Scene& scene, const build::DeviceScene& deviceScene, build::RasterPass& raster,
                            const build::RasterPass::Report& report) {
  views_.clear();
  lightMaps_.clear();
  bounds_ = deviceScene.bounds();
  for (const Light& light : scene.lights) {
    const auto views = cluster::lightViews(light, bounds_, scene.shadows.mapSize);
    lightMaps_.push_back({shared::uint(views_.size()), shared::uint(views.size())});
    views_.insert(views_.end(), views.begin(), views.end());
  }
  const auto maps = pass_.run(deviceScene, views_, scene.shadows.tolerance, raster, *memory_, report);
  maps_ = device::Buffer<shared::MapData>::fromHost(device_, maps, "maps");
}

shared::TechniqueParams DeepShadowMap::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.memory = memory_->params();
  params.bilinear = scene.shadows.filter == "bilinear";
  return params;
}

device::ArgumentList DeepShadowMap::arguments() const {
  device::ArgumentList list{maps_.cl()};
  const device::ArgumentList nodes = memory_->readArguments();
  list.insert(list.end(), nodes.begin(), nodes.end());
  return list;
}

void DeepShadowMap::addStats(const Scene& scene, bool regenerated, FrameStats& stats) const {
  std::vector<std::string> objects;
  for (const Mesh& mesh : scene.meshes) objects.push_back(mesh.name);
  for (const Volume& volume : scene.volumes) objects.push_back(volume.name);
  for (std::size_t light = 0; light < lightMaps_.size(); ++light)
    for (unsigned i = 0; i < lightMaps_[light].y; ++i) {
      stats.lights[light].maps.push_back(mapStats(lightMaps_[light].x + i));
      stats.lights[light].maps.back().objects = objects;
      stats.lights[light].maps.back().regenerated = regenerated;
    }
  stats.memory = memory_->stats();
}

MapStats DeepShadowMap::mapStats(std::size_t index) const {
  const shared::ViewData& view = views_[index];
  const memory::NodeCounts nodes = memory_->nodeCounts(index);
  MapStats map;
  map.texels = std::uint64_t(view.width) * view.height;
  map.nodesTotal = nodes.total;
  map.nodesMax = nodes.most;
  map.nodesMean = double(nodes.total) / double(map.texels);
  map.fovX = map.fovY = cluster::mapFov(view);
  map.nearDepth = view.nearDepth;
  map.farDepth = farthestDepth(view, bounds_);
  return map;
}

}  // namespace cdsm::technique
