// SPDX-License-Identifier: Apache-2.0
// Technique "deep-shadow-map": one compressed visibility function per texel of each light's maps [Knecht 2011, §3.2],
// one map or more for each cluster of objects [Knecht 2011, §3.4].
#pragma once

#include <functional>
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
  using MakeMemory = std::function<std::unique_ptr<memory::MemoryStrategy>()>;

  DeepShadowMap(device::Device& device, MakeMemory makeMemory);

  build::Defines kernelFiles() const override;
  void prepare(const Preparation& to) override;
  void describeLight(std::size_t light, shared::LightData& data) const override;
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override;
  const std::vector<MapCluster>* clusters() const override { return &clusters_; }
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
  /// Builds what is not kept at a tolerance at which all maps fit in the memory that they may take.
  void buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs);
  /// Bytes of the maps after building those that are not kept at a tolerance.
  std::uint64_t buildMapsAt(float tolerance, const Preparation& to, const std::vector<build::MapJob>& jobs);
  /// The same for all maps, in memory that knows nothing of the maps before.
  std::uint64_t buildAllAt(float tolerance, const Preparation& to, std::vector<build::MapJob> jobs);
  MapStats mapStats(const Scene& scene, const MapCluster& cluster, std::size_t view) const;

  device::Device& device_;
  MakeMemory makeMemory_;
  std::unique_ptr<memory::MemoryStrategy> memory_;
  build::MapPass pass_;
  cluster::MeshShapes meshShapes_;
  std::vector<cluster::HandOver> handOvers_;  ///< per light, if stable
  std::optional<Scene> built_;                ///< what the maps were built for
  float builtTolerance_ = 0.0f;               ///< that of the maps
  std::vector<MapCluster> clusters_;
  std::vector<LightMaps> lightMaps_;
  std::vector<shared::MapData> mapData_;
  device::Buffer<shared::MapData> maps_;
  double clusterMs_ = 0.0;
};

}  // namespace cdsm::technique
