// SPDX-License-Identifier: Apache-2.0
// Technique "none": no shadows.
#pragma once

#include "technique/shadow_technique.hpp"

namespace cdsm::technique {

class None : public ShadowTechnique {
 public:
  build::Defines kernelFiles() const override { return {{"CDSM_TECHNIQUE", "\"technique/none.clh\""}}; }
  void prepare(const Scene&, const build::DeviceScene&, build::RasterPass&, const build::RasterPass::Report&) override {
  }
  shared::uint2 mapsOf(std::size_t) const override { return {}; }
  shared::TechniqueParams params(const Scene&) const override { return {}; }
  device::ArgumentList arguments() const override { return {}; }
  void addStats(const Scene&, bool, FrameStats&) const override {}
};

}  // namespace cdsm::technique
