// SPDX-License-Identifier: Apache-2.0
// How shadows are made. A technique is one kernel file (kernels/technique/NAME.clh, which defines
// lightTransmittanceBatch, -Surface and -Point), one pair of host files and one line in the registry.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>
#include <cdsm/stats.hpp>

#include "build/device_scene.hpp"
#include "build/raster_pass.hpp"
#include "build/variant.hpp"
#include "shared/frame_data.h"
#include "shared/map_data.h"

namespace cdsm::technique {

class ShadowTechnique {
 public:
  virtual ~ShadowTechnique() = default;

  /// CDSM_TECHNIQUE, and CDSM_MEMORY if it uses one.
  virtual build::Defines kernelFiles() const = 0;

  /// Makes what lookups need, for a scene that has changed. Lights' maps are counted in the order of the lights.
  virtual void prepare(const Scene& scene, const build::DeviceScene& deviceScene, build::RasterPass& raster,
                       const build::RasterPass::Report& report) = 0;

  /// Maps of light number `light`: first and count.
  virtual shared::uint2 mapsOf(std::size_t light) const = 0;
  virtual shared::TechniqueParams params(const Scene& scene) const = 0;
  /// Arguments of CDSM_TECHNIQUE_PARAMS behind TechniqueParams.
  virtual device::ArgumentList arguments() const = 0;

  /// Adds its maps and memory. `regenerated`: prepare() ran for this frame.
  virtual void addStats(const Scene& scene, bool regenerated, FrameStats& stats) const = 0;
};

}  // namespace cdsm::technique
