// SPDX-License-Identifier: Apache-2.0
// Technique "implicit-sphere": the nearest sphere per texel of each light's maps, itself and not its depth [Krone
// 2017].
#pragma once

#include "build/depth_pass.hpp"
#include "technique/map_technique.hpp"

namespace cdsm::technique {

class ImplicitSphere : public MapTechnique {
 public:
  static constexpr std::size_t kFloats = 4;  ///< per texel: a sphere's centre and radius

  explicit ImplicitSphere(device::Device& device) : MapTechnique(device), pass_(device, kFloats, kFloats) {}

  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", "\"technique/implicit_sphere.clh\""}}; }
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override { return {maps().cl(), pass_.depths().cl()}; }

 private:
  bool drawsInMaps(scene::ObjectKind kind) const override { return kind == scene::ObjectKind::Spheres; }
  std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs,
                                         std::vector<MapCluster>& clusters) override;
  /// A texel has one sphere.
  memory::NodeCounts nodeCounts(std::size_t map) const override;
  MemoryStats memoryStats() const override;

  build::DepthPass pass_;
  std::vector<std::size_t> texels_;  ///< per map
};

}  // namespace cdsm::technique
