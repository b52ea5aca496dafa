// SPDX-License-Identifier: Apache-2.0
// Fragments of the camera's view -> what a debug picture shows of each ray.
#pragma once

#include <cstdint>
#include <vector>

#include "build/device_scene.hpp"
#include "build/raster_pass.hpp"
#include "shared/debug_data.h"
#include "technique/shadow_technique.hpp"

namespace cdsm::render {

class DebugPass {
 public:
  explicit DebugPass(device::Device& device) : device_(device) {}

  /// Row after row; `technique` must be one with maps, `light` is the number of the light that they belong to.
  std::vector<shared::MapProbe> probeMaps(const Scene& scene, const build::DeviceScene& deviceScene,
                                          build::Layers& layers, std::size_t light,
                                          const device::Buffer<shared::LightData>& lights,
                                          const technique::ShadowTechnique& technique);

 private:
  device::Device& device_;
};

/// Fragments of each pixel, row after row.
std::vector<std::uint32_t> layerCounts(const build::Layers& layers);

}  // namespace cdsm::render
