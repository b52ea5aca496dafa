// SPDX-License-Identifier: Apache-2.0
// Technique "shadow-rays": every sample marches to the light [Ropinski 2008, §3.1].
#pragma once

#include "technique/shadow_technique.hpp"

#include "shared/bvh_data.h"

namespace cdsm::technique {

class ShadowRays : public ShadowTechnique {
 public:
  explicit ShadowRays(device::Device& device) : device_(device) {}

  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", "\"technique/shadow_rays.clh\""}}; }
  void prepare(const Preparation& to) override;
  /// The objects around the light, in place of maps.
  void describeLight(std::size_t light, shared::LightData& data) const override;
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override;
  void addStats(const Scene&, FrameStats&) const override {}

 private:
  void buildHierarchy(const Scene& scene, const build::DeviceScene& deviceScene);

  device::Device& device_;
  std::size_t mediumCount_ = 0;
  std::vector<shared::uint2> around_;  ///< per light: first and number in lightObjects_
  device::Buffer<shared::BvhNode> nodes_;
  device::Buffer<shared::BvhPrimitive> primitives_;
  device::Buffer<std::uint32_t> lightObjects_, mediumObjects_;
  device::Buffer<float> opaqueExtinctions_;
  cl::Buffer lightExtinctions_;  ///< of the device scene
};

}  // namespace cdsm::technique
