// SPDX-License-Identifier: Apache-2.0
// Views of lights -> finished deep shadow maps [Knecht 2011, §3.2, Alg. 3.1].
#pragma once

#include <vector>

#include "build/device_scene.hpp"
#include "build/raster_pass.hpp"
#include "memory/memory_strategy.hpp"
#include "shared/frame_data.h"

namespace cdsm::build {

/// What |V' - V| <= tolerance is to mean.
struct MapAccuracy {
  float tolerance;  ///< epsilon of the maps, the errors of what is stored included, in opacity
  bool everywhere;  ///< at every depth, of the exact integral; false: at the samples of the ray
};

/// A map to build, or to take over.
struct MapJob {
  shared::MapData map;  ///< where points land in it
  shared::ViewData view;
  std::vector<unsigned> casters;  ///< objects that cast in it
  int kept = memory::kBuildAnew;  ///< number of the map before that it is
};

class MapPass {
 public:
  explicit MapPass(device::Device& device) : device_(device) {}

  /// Builds into `memory` the maps that are not taken over; returns them with the places of their nodes.
  std::vector<shared::MapData> run(const DeviceScene& scene, const std::vector<MapJob>& jobs,
                                   const MapAccuracy& accuracy, RasterPass& raster, memory::MemoryStrategy& memory,
                                   const RasterPass::Report& report);

 private:
  using BuildKernel = device::Kernel<shared::BuildParams, device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>,
                                     device::Buffer<shared::MapData>, shared::MemoryParams, device::ArgumentList,
                                     device::ArgumentList, device::ArgumentList, device::ArgumentList>;

  device::Device& device_;
};

}  // namespace cdsm::build
