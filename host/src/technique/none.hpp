// SPDX-License-Identifier: Apache-2.0
// Technique "none": no shadows.
#pragma once

#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

class None : public ShadowTechnique {
 public:
  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", "\"technique/none.clh\""}}; }
  void prepare(const Preparation&) override {}
  void describeLight(std::size_t, shared::LightData&) const override {}
  shared::TechniqueParams params(const Scene&) const override { return {}; }
  device::ArgumentList arguments() const override { return {}; }
  void addStats(const Scene&, FrameStats&) const override {}
};

}  // namespace cdsm::technique
