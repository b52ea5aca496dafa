// SPDX-License-Identifier: Apache-2.0
// Technique "deep-shadow-map": one compressed visibility function per texel of each light's maps [Knecht 2011, §3.2],
// one map or more for each cluster of objects [Knecht 2011, §3.4].
#pragma once

#include <memory>
#include <optional>

#include "build/map_pass.hpp"
#include "cluster/hand_over.hpp"
#include "memory/memory_strategy.hpp"
#include "technique/map_cluster.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

class DeepShadowMap : public ShadowTechnique {
 public:
  DeepShadowMap(device::Device& device, std::unique_ptr<memory::MemoryStrategy> memory);

  build::Defines kernelFiles() const override;
  void prepare(const Preparation& to) override;
  void describeLight(std::size_t light, shared::LightData& data) const override;
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override;
  std::vector<LightMap> lightMaps(const Scene& scene, std::size_t light) const override;
  void addStats(const Scene& scene, FrameStats& stats) const override;

 private:
  /// A light's maps: those of its clusters, behind them those of clusters that fade out.
  struct LightMaps {
    std::size_t first = 0, count = 0, formerCount = 0;
    float share = 1.0f;
  };

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
  std::unique_ptr<memory::MemoryStrategy> memory_;
  build::MapPass pass_;
  cluster::MeshShapes meshShapes_;
  std::vector<cluster::HandOver> handOvers_;  ///< per light, if stable
  std::optional<Scene> built_;                ///< what the maps were built for
  std::vector<MapCluster> clusters_;
  std::vector<LightMaps> lightMaps_;
  std::vector<shared::MapData> mapData_;
  device::Buffer<shared::MapData> maps_;
  double clusterMs_ = 0.0;
};

}  // namespace cdsm::technique
