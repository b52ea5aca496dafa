// SPDX-License-Identifier: Apache-2.0
// What techniques with maps share: which maps each light needs, one or more for each of its clusters of objects [Knecht
// 2011, §3.4], which of them can stay, and what the statistics say of them. How a map is built and kept is up to the
// technique.
#pragma once

#include <optional>

#include "build/map_pass.hpp"
#include "cluster/hand_over.hpp"
#include "memory/memory_strategy.hpp"
#include "scene/objects.hpp"
#include "technique/map_cluster.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

class MapTechnique : public ShadowTechnique {
 public:
  explicit MapTechnique(device::Device& device) : device_(device) {}

  void prepare(const Preparation& to) override;
  void describeLight(std::size_t light, shared::LightData& data) const override;
  const std::vector<MapCluster>* clusters() const override { return &clusters_; }
  void addStats(const Scene& scene, FrameStats& stats) const override;

 protected:
  /// Whether objects of this kind cast by this technique.
  virtual bool drawsInMaps(scene::ObjectKind) const { return true; }

  /// A light's maps: those of its clusters, behind them those of clusters that fade out.
  struct LightMaps {
    std::size_t first = 0, count = 0, formerCount = 0;
    float share = 1.0f;
  };

  /// Builds the maps that are not taken over; returns all, with the places of what is kept of them. If it throws, all
  /// are built anew the next time. A cluster without a reason stays; if it is built all the same, its reason is said.
  virtual std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                                 std::vector<MapCluster>& clusters) = 0;
  virtual memory::NodeCounts nodeCounts(std::size_t map) const = 0;
  virtual MemoryStats memoryStats() const = 0;

  device::Device& device() const { return device_; }
  /// Where points land in the maps.
  const device::Buffer<shared::MapData>& maps() const { return maps_; }
  const LightMaps& mapsOf(std::size_t light) const { return lightMaps_[light]; }
  /// Texel widths that surface points are moved towards the light: some, unless the scene gives a bias.
  static float texelBias(const Scene& scene) { return scene.shadows.bias > 0.0f ? 0.0f : 0.5f; }

 private:
  /// Those that may cast in its maps.
  std::vector<cluster::Caster> drawnShapes(const Scene& scene, std::vector<cluster::Caster> shapes) const;
  /// The clusters of all lights as they should be, without maps; what they are to their lights goes to lightMaps_.
  std::vector<MapCluster> planClusters(const Preparation& to, const std::vector<cluster::Caster>& shapes);
  /// The clusters of one light: as planned, or as they are handed over. `share`: of the current ones.
  cluster::LightClusters handedOver(const Preparation& to, std::size_t light, cluster::LightPlan plan,
                                    cluster::LightClusters& former, float& share);
  /// Finds out which maps can stay and gives the other clusters their cameras.
  std::vector<build::MapJob> makeJobs(const Scene& scene, const std::vector<cluster::Caster>& shapes,
                                      std::vector<MapCluster>& clusters);
  MapStats mapStats(const Scene& scene, const MapCluster& cluster, std::size_t view) const;

  device::Device& device_;
  cluster::KnownShapes knownShapes_;
  std::vector<cluster::HandOver> handOvers_;  ///< per light, if stable
  std::optional<Scene> built_;                ///< what the maps were built for
  std::vector<MapCluster> clusters_;
  std::vector<LightMaps> lightMaps_;
  std::vector<shared::MapData> mapData_;
  device::Buffer<shared::MapData> maps_;
  double clusterMs_ = 0.0;
};

}  // namespace cdsm::technique
