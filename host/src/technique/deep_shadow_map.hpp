// SPDX-License-Identifier: Apache-2.0
// Technique "deep-shadow-map": one compressed visibility function per texel of each light's maps [Knecht 2011, §3.2].
#pragma once

#include <functional>
#include <memory>

#include "technique/map_technique.hpp"

namespace cdsm::technique {

class DeepShadowMap : public MapTechnique {
 public:
  using MakeMemory = std::function<std::unique_ptr<memory::MemoryStrategy>()>;

  DeepShadowMap(device::Device& device, MakeMemory makeMemory);

  build::Defines kernelFiles() const override;
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override;
  std::vector<LightMap> lightMaps(const Scene& scene, std::size_t light) const override;
  void addStats(const Scene& scene, FrameStats& stats) const override;

 private:
  /// At a tolerance at which all maps fit in the memory that they may take.
  std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                         std::vector<MapCluster>& clusters) override;
  memory::NodeCounts nodeCounts(std::size_t map) const override { return memory_->nodeCounts(map); }
  MemoryStats memoryStats() const override;

  /// The maps, of which those that are not kept are built at a tolerance.
  std::vector<shared::MapData> buildMapsAt(float tolerance, const Preparation& to,
                                           const std::vector<build::MapJob>& jobs);
  /// The same for all maps, in memory that knows nothing of the maps before.
  std::vector<shared::MapData> buildAllAt(float tolerance, const Preparation& to, std::vector<build::MapJob> jobs);

  MakeMemory makeMemory_;
  std::unique_ptr<memory::MemoryStrategy> memory_;
  build::MapPass pass_;
  float builtTolerance_ = 0.0f;  ///< that of the maps
};

}  // namespace cdsm::technique
