// SPDX-License-Identifier: Apache-2.0
#include "technique/implicit_sphere.hpp"

namespace cdsm::technique {

namespace {

/// Texels around its centre that a sphere covers at least: a circle of half the diagonal of a texel holds the middle of
/// one, wherever it lies.
constexpr float kLeastRadius = 0.71f;

}  // namespace

build::StopRule ImplicitSphere::stopRule(const Preparation& to) {
  build::StopRule rule{"\"build/stop_sphere.clh\"", {}, {}, kLeastRadius};
  rule.params.threshold = to.scene.shadows.threshold;
  return rule;
}

shared::TechniqueParams ImplicitSphere::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.patch = scene.shadows.patch;
  params.softness = scene.shadows.softness;
  params.softnessDistance = scene.shadows.softnessDistance;
  params.softnessExponent = scene.shadows.softnessExponent;
  return params;
}

}  // namespace cdsm::technique
