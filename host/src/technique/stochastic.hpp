// SPDX-License-Identifier: Apache-2.0
// Technique "stochastic": per texel the depths at which three photons were stopped, by chance; what gets through is the
// part of the photons of many texels [Weidner & Linsen 2018].
#pragma once

#include "technique/depth_technique.hpp"

namespace cdsm::technique {

class Stochastic : public DepthTechnique {
 public:
  explicit Stochastic(device::Device& device)
      : DepthTechnique(device, {"\"technique/stochastic.clh\"", "depth", 3, 1, 8}) {}

  /// Differences of neighbouring lookups are noise, up to its standard deviation.
  float lookupTolerance(const Scene& scene) const override;
  shared::TechniqueParams params(const Scene& scene) const override;

 private:
  build::StopRule stopRule(const Preparation& to) override;
};

}  // namespace cdsm::technique
