// SPDX-License-Identifier: Apache-2.0
#include "technique/shadow_map.hpp"

namespace cdsm::technique {

build::StopRule ShadowMap::stopRule(const Preparation& to) {
  const float threshold = to.scene.shadows.threshold;
  limits_ =
      device::Buffer<float>::fromHost(device(), to.deviceScene.opaqueExtinctions(threshold), "opaque extinctions");
  build::StopRule rule{"\"build/stop_opaque.clh\"", {}, {limits_.cl()}};
  rule.params.threshold = threshold;
  return rule;
}

shared::TechniqueParams ShadowMap::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.bilinear = scene.shadows.filter == "bilinear";
  params.texelBias = texelBias(scene);
  params.pcf = scene.shadows.pcf;
  return params;
}

}  // namespace cdsm::technique
