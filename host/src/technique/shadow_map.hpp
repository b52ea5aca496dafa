// SPDX-License-Identifier: Apache-2.0
// Technique "shadow-map": the depth of what stops the light per texel of each light's maps [Ropinski 2008, §3.2].
#pragma once

#include "technique/depth_technique.hpp"

namespace cdsm::technique {

class ShadowMap : public DepthTechnique {
 public:
  explicit ShadowMap(device::Device& device)
      : DepthTechnique(device, {"\"technique/shadow_map.clh\"", "depth", 1, 1, 1}) {}

  shared::TechniqueParams params(const Scene& scene) const override;

 private:
  build::StopRule stopRule(const Preparation& to) override;

  device::Buffer<float> limits_;  ///< per medium, see DeviceScene::opaqueExtinctions()
};

}  // namespace cdsm::technique
