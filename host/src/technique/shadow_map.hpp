// SPDX-License-Identifier: Apache-2.0
// Technique "shadow-map": the depth of what stops the light per texel of each light's maps [Ropinski 2008, §3.2].
#pragma once

#include "build/depth_pass.hpp"
#include "technique/map_technique.hpp"

namespace cdsm::technique {

class ShadowMap : public MapTechnique {
 public:
  explicit ShadowMap(device::Device& device) : MapTechnique(device), pass_(device, 1, 1) {}

  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", "\"technique/shadow_map.clh\""}}; }
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override { return {maps().cl(), pass_.depths().cl()}; }

 private:
  std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                         std::vector<MapCluster>& clusters) override;
  /// A texel has one depth.
  memory::NodeCounts nodeCounts(std::size_t map) const override;
  MemoryStats memoryStats() const override;

  build::DepthPass pass_;
  std::vector<std::size_t> texels_;  ///< per map
};

}  // namespace cdsm::technique
