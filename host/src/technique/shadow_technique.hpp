// SPDX-License-Identifier: Apache-2.0
// How shadows are made. A technique is one kernel file (kernels/technique/NAME.clh, which defines
// lightTransmittanceBatch, -Surface and -Point), one pair of host files and one line in the registry.
#pragma once

#include <vector>

#include <cdsm/error.hpp>
#include <cdsm/light_map.hpp>
#include <cdsm/scene.hpp>
#include <cdsm/stats.hpp>

#include "build/device_scene.hpp"
#include "build/raster_pass.hpp"
#include "build/variant.hpp"
#include "cluster/cluster_plan.hpp"
#include "shared/frame_data.h"
#include "shared/map_data.h"

namespace cdsm::technique {

/// What a technique makes its lookups from.
struct Preparation {
  const Scene& scene;
  const build::DeviceScene& deviceScene;
  build::RasterPass& raster;
  const build::RasterPass::Report& report;
  cluster::Purpose purpose;
  bool objectsChanged;  ///< since the last time, or there was none
};

struct MapCluster;

class ShadowTechnique {
 public:
  virtual ~ShadowTechnique() = default;

  /// CDSM_TECHNIQUE, and CDSM_MEMORY if it uses one.
  virtual build::Defines kernelFiles() const = 0;

  /// Makes what lookups need for this frame, as far as it has changed.
  virtual void prepare(const Preparation& to) = 0;

  /// Says in `data` which maps light number `light` has.
  virtual void describeLight(std::size_t light, shared::LightData& data) const = 0;
  /// Differences below which lookups along a camera ray may be interpolated.
  virtual float lookupTolerance(const Scene& scene) const { return scene.shadows.tolerance; }
  virtual shared::TechniqueParams params(const Scene& scene) const = 0;
  /// Arguments of CDSM_TECHNIQUE_PARAMS behind TechniqueParams.
  virtual device::ArgumentList arguments() const = 0;

  /// The clusters of all lights with their maps; null for techniques that have none.
  virtual const std::vector<MapCluster>* clusters() const { return nullptr; }

  /// The maps of light number `light`, in the order of describeLight(), without their nodes. Throws Error for a
  /// technique that has none.
  virtual std::vector<LightMap> lightMaps(const Scene& scene, std::size_t) const {
    throw Error("the technique '" + scene.shadows.technique +
                "' keeps no deep shadow maps; shadows.technique must be deep-shadow-map");
  }

  /// Adds its maps and memory.
  virtual void addStats(const Scene& scene, FrameStats& stats) const = 0;
};

}  // namespace cdsm::technique
