// SPDX-License-Identifier: Apache-2.0
#include "technique/deep_shadow_map.hpp"

#include "cluster/light_camera.hpp"

namespace cdsm::technique {

namespace {

/// Nothing nearer to a light than this part of the scene's size casts a shadow.
constexpr float kNearPart = 1e-6f;

/// Depth of the farthest corner of the bounds.
float farthestDepth(const shared::ViewData& view, const scene::Bounds& bounds) {
  const glm::vec3 axis(view.depth.x, view.depth.y, view.depth.z);
  return glm::dot(axis, glm::mix(bounds.low, bounds.high, glm::vec3(glm::greaterThan(axis, glm::vec3(0.0f))))) +
         view.depth.w;
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
  const float nearDepth = std::max(kNearPart * deviceScene.bounds().diagonal(), 1e-20f);
  views_.clear();
  bounds_ = deviceScene.bounds();
  for (const Light& light : scene.lights) views_.push_back(cluster::spotView(light, scene.shadows.mapSize, nearDepth));
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
  for (std::size_t i = 0; i < views_.size(); ++i) {
    MapStats map;
    for (const Mesh& mesh : scene.meshes) map.objects.push_back(mesh.name);
    for (const Volume& volume : scene.volumes) map.objects.push_back(volume.name);
    map.regenerated = regenerated;
    map.texels = std::uint64_t(views_[i].width) * views_[i].height;
    const memory::NodeCounts nodes = memory_->nodeCounts(i);
    map.nodesTotal = nodes.total;
    map.nodesMax = nodes.most;
    map.nodesMean = double(nodes.total) / double(map.texels);
    map.fovX = map.fovY = cluster::mapFov(scene.lights[i], views_[i].width);
    map.nearDepth = views_[i].nearDepth;
    map.farDepth = farthestDepth(views_[i], bounds_);
    stats.lights[i].maps.push_back(map);
  }
  stats.memory = memory_->stats();
}

}  // namespace cdsm::technique
