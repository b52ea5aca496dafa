// SPDX-License-Identifier: Apache-2.0
// Views of lights -> shadow maps: per texel the depth of what stops the light [Ropinski 2008, §3.2].
#pragma once

#include <vector>

#include "build/device_scene.hpp"
#include "build/map_pass.hpp"
#include "build/raster_pass.hpp"
#include "shared/frame_data.h"

namespace cdsm::build {

/// Keeps the depths of all maps, one map after the other.
class DepthPass {
 public:
  explicit DepthPass(device::Device& device) : device_(device), depths_(device, 0, "depths of shadow maps") {}

  /// Builds the maps that are not taken over; returns all with the places of their texels. What is more opaque than
  /// `threshold` stops the light. Throws DeviceError if the maps are too large.
  std::vector<shared::MapData> run(const DeviceScene& scene, const std::vector<MapJob>& jobs, float threshold,
                                   RasterPass& raster, const RasterPass::Report& report);

  const device::Buffer<float>& depths() const { return depths_; }

 private:
  using Floats = device::Buffer<float>;
  using DepthKernel = device::Kernel<shared::DepthParams, device::Buffer<std::uint64_t>, device::Buffer<shared::uint2>,
                                     Floats, Floats, device::ArgumentList>;

  /// Places for the texels of all maps, with the depths of those that are taken over.
  std::vector<shared::MapData> place(const std::vector<MapJob>& jobs);

  device::Device& device_;
  Floats depths_;
};

}  // namespace cdsm::build
