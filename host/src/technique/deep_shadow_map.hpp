// SPDX-License-Identifier: Apache-2.0
// Technique "deep-shadow-map": one compressed visibility function per texel of each light's maps [Knecht 2011, §3.2].
#pragma once

#include <memory>

#include "build/map_pass.hpp"
#include "memory/memory_strategy.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

class DeepShadowMap : public ShadowTechnique {
 public:
  DeepShadowMap(device::Device& device, std::unique_ptr<memory::MemoryStrategy> memory);

  build::Defines kernelFiles() const override;
  void prepare(const Scene& scene, const build::DeviceScene& deviceScene, build::RasterPass& raster,
               const build::RasterPass::Report& report) override;
  shared::uint2 mapsOf(std::size_t light) const override { return lightMaps_[light]; }
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override;
  void addStats(const Scene& scene, bool regenerated, FrameStats& stats) const override;

 private:
  /// All but what the light's maps have in common.
  MapStats mapStats(std::size_t index) const;

  device::Device& device_;
  std::unique_ptr<memory::MemoryStrategy> memory_;
  build::MapPass pass_;
  std::vector<shared::ViewData> views_;   ///< of all maps
  std::vector<shared::uint2> lightMaps_;  ///< per light: first map and number
  device::Buffer<shared::MapData> maps_;
  scene::Bounds bounds_;
};

}  // namespace cdsm::technique
