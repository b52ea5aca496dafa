// SPDX-License-Identifier: Apache-2.0
// Views of lights -> shadow maps: per texel the depth of what stops the light [Ropinski 2008, §3.2], or several of them
// [Weidner & Linsen 2018, §3].
#pragma once

#include <vector>

#include "build/device_scene.hpp"
#include "build/map_pass.hpp"
#include "build/raster_pass.hpp"
#include "shared/frame_data.h"

namespace cdsm::build {

/// What stops the light.
struct StopRule {
  const char* kernelFile;          ///< CDSM_STOP, quoted
  shared::DepthParams params;      ///< view, first texel and the map's own seed are up to the pass
  device::ArgumentList arguments;  ///< of CDSM_STOP_PARAMS
  float leastRadius = 0.0f;        ///< texels around its centre that a sphere covers at least
};

/// Keeps the depths of all maps, one map after the other.
class DepthPass {
 public:
  /// `readAtOnce`: depths that a lookup may read from the first one of a texel on.
  DepthPass(device::Device& device, std::size_t depthsPerTexel, std::size_t readAtOnce)
      : device_(device),
        depthsPerTexel_(depthsPerTexel),
        readBeyond_(readAtOnce - depthsPerTexel),
        depths_(device, 0, "depths of shadow maps") {}

  /// Builds the maps that are not taken over; returns all with the places of their texels. Throws DeviceError if the
  /// maps are too large.
  std::vector<shared::MapData> run(const DeviceScene& scene, const std::vector<MapJob>& jobs, const StopRule& rule,
                                   RasterPass& raster, const RasterPass::Report& report);

  const device::Buffer<float>& depths() const { return depths_; }

 private:
  using Floats = device::Buffer<float>;
  using DepthKernel = device::Kernel<shared::DepthParams, device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>,
                                     Floats, device::ArgumentList, device::ArgumentList>;

  /// Places for the texels of all maps, with the depths of those that are taken over.
  std::vector<shared::MapData> place(const std::vector<MapJob>& jobs);

  device::Device& device_;
  std::size_t depthsPerTexel_, readBeyond_;
  Floats depths_;
};

}  // namespace cdsm::build
