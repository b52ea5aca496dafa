// SPDX-License-Identifier: Apache-2.0
// Technique "implicit-sphere": the nearest sphere per texel of each light's maps, itself and not its depth [Krone
// 2017].
#pragma once

#include "technique/depth_technique.hpp"

namespace cdsm::technique {

class ImplicitSphere : public DepthTechnique {
 public:
  explicit ImplicitSphere(device::Device& device)
      : DepthTechnique(device, {"\"technique/implicit_sphere.clh\"", "sphere", 1, 4, 4}) {}

  shared::TechniqueParams params(const Scene& scene) const override;

 private:
  bool drawsInMaps(scene::ObjectKind kind) const override { return kind == scene::ObjectKind::Spheres; }
  build::StopRule stopRule(const Preparation& to) override;
};

}  // namespace cdsm::technique
