// SPDX-License-Identifier: Apache-2.0
#include "technique/map_technique.hpp"

#include <algorithm>
#include <chrono>

#include "cluster/light_camera.hpp"
#include "device/host_step.hpp"

namespace cdsm::technique {

std::vector<cluster::Caster> MapTechnique::drawnShapes(const Scene& scene, std::vector<cluster::Caster> shapes) const {
  const auto other = [&](const cluster::Caster& shape) {
    return !drawsInMaps(scene::placeOf(scene, shape.object).kind);
  };
  shapes.erase(std::remove_if(shapes.begin(), shapes.end(), other), shapes.end());
  return shapes;
}

void MapTechnique::prepare(const Preparation& to) {
  const auto begun = std::chrono::steady_clock::now();
  knownShapes_.keepOnly(to.scene);
  const std::vector<cluster::Caster> shapes = cluster::objectShapes(to.scene, knownShapes_);
  std::vector<MapCluster> clusters = planClusters(to, drawnShapes(to.scene, shapes));
  clusterMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();

  const std::vector<build::MapJob> jobs = makeJobs(to.scene, shapes, clusters);
  bool same = jobs.size() == mapData_.size() && maps_.allocated();
  for (std::size_t i = 0; i < jobs.size(); ++i) same = same && jobs[i].kept == int(i);
  built_.reset();
  if (!same) {
    mapData_ = buildMaps(to, jobs, clusters);
    maps_ = device::Buffer<shared::MapData>::fromHost(device_, mapData_, "maps");
  }
  clusters_ = std::move(clusters);
  built_ = to.scene;
}

cluster::LightClusters MapTechnique::handedOver(const Preparation& to, std::size_t light, cluster::LightPlan plan,
                                                cluster::LightClusters& former, float& share) {
  if (!to.scene.shadows.stable) return std::move(plan.clusters);
  cluster::HandOver& handOver = handOvers_[light];
  if (to.purpose == cluster::Purpose::Image || !handOver.fits(plan)) handOver.next(plan);
  former = handOver.former();
  share = handOver.share();
  return handOver.current();
}

std::vector<MapCluster> MapTechnique::planClusters(const Preparation& to, const std::vector<cluster::Caster>& shapes) {
  const device::HostStep step(device_.profiler().trace(), "plan clusters");
  const Scene& scene = to.scene;
  const bool focused = scene.shadows.clusters > 1;
  const scene::Bounds& bounds = to.deviceScene.bounds();
  const cluster::VisibleSpace visible =
      cluster::visibleSpace(scene.camera, double(scene.image.width) / double(scene.image.height),
                            scene::cameraNearDepth(scene.camera, bounds), bounds);
  // clusters that stay must be good for every camera
  const cluster::Purpose purpose = scene.shadows.stable ? cluster::Purpose::Points : to.purpose;
  handOvers_.resize(scene.shadows.stable ? scene.lights.size() : 0);
  lightMaps_.assign(scene.lights.size(), {});
  std::vector<MapCluster> clusters;
  for (std::size_t light = 0; light < scene.lights.size(); ++light) {
    cluster::LightPlan plan = focused ? cluster::planLight(scene, scene.lights[light], shapes, visible, purpose)
                                      : cluster::planWithoutClusters(scene, shapes);
    cluster::LightClusters former;
    const auto current = handedOver(to, light, std::move(plan), former, lightMaps_[light].share);
    unsigned number = 0;
    for (const auto& objects : current) clusters.push_back({light, number++, focused, false, objects, {}, 0, {}});
    for (const auto& objects : former) clusters.push_back({light, number++, focused, true, objects, {}, 0, {}});
  }
  return clusters;
}

std::vector<build::MapJob> MapTechnique::makeJobs(const Scene& scene, const std::vector<cluster::Caster>& shapes,
                                                  std::vector<MapCluster>& clusters) {
  const int size = scene.shadows.mapSize;
  std::vector<build::MapJob> jobs;
  for (MapCluster& cluster : clusters) {
    const Light& light = scene.lights[cluster.light];
    const auto kept = keptCluster(built_, scene, clusters_, cluster);
    if (kept)
      cluster.views = clusters_[*kept].views;
    else
      cluster.views = cluster.focused ? cluster::focusedViews(scene, light, shapes, cluster.objects, size)
                                      : cluster::wholeViews(light, shapes, cluster.objects, size);
    cluster.firstMap = jobs.size();
    LightMaps& lightMaps = lightMaps_[cluster.light];
    if (lightMaps.count + lightMaps.formerCount == 0) lightMaps.first = jobs.size();
    (cluster.former ? lightMaps.formerCount : lightMaps.count) += cluster.views.size();
    for (std::size_t i = 0; i < cluster.views.size(); ++i) {
      const cluster::MapView& view = cluster.views[i];
      const int from = kept ? int(clusters_[*kept].firstMap + i) : memory::kBuildAnew;
      jobs.push_back({kept ? mapData_[std::size_t(from)] : cluster::mapData(view.view, view.face), view.view,
                      cluster.objects, from});
    }
  }
  return jobs;
}

void MapTechnique::describeLight(std::size_t light, shared::LightData& data) const {
  const LightMaps& maps = lightMaps_[light];
  data.firstMap = shared::uint(maps.first);
  data.mapCount = shared::uint(maps.count);
  data.formerCount = shared::uint(maps.formerCount);
  data.share = maps.share;
}

void MapTechnique::addStats(const Scene& scene, FrameStats& stats) const {
  for (const MapCluster& cluster : clusters_)
    for (std::size_t view = 0; view < cluster.views.size(); ++view)
      stats.lights[cluster.light].maps.push_back(mapStats(scene, cluster, view));
  stats.clusterMs = clusterMs_;
  stats.memory = memoryStats();
}

MapStats MapTechnique::mapStats(const Scene& scene, const MapCluster& cluster, std::size_t index) const {
  const cluster::MapView& view = cluster.views[index];
  const memory::NodeCounts nodes = nodeCounts(cluster.firstMap + index);
  MapStats map;
  map.cluster = int(cluster.number);
  for (const unsigned object : cluster.objects) map.objects.push_back(scene::objectName(scene, object));
  map.regenerated = !cluster.reason.empty();
  map.reason = cluster.reason;
  map.texels = std::uint64_t(view.view.width) * view.view.height;
  map.nodesTotal = nodes.total;
  map.nodesMax = nodes.most;
  map.nodesMean = double(nodes.total) / double(map.texels);
  map.fovX = view.fovX;
  map.fovY = view.fovY;
  map.nearDepth = view.nearDepth;
  map.farDepth = view.farDepth;
  return map;
}

}  // namespace cdsm::technique
