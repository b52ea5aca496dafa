// SPDX-License-Identifier: Apache-2.0
// Nodes of a finished map -> host memory, through the lookup of its memory strategy.
#pragma once

#include <cdsm/light_map.hpp>

#include "build/device_scene.hpp"
#include "device/scan.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::render {

class MapReader {
 public:
  explicit MapReader(device::Device& device) : device_(device), scan_(device) {}

  /// Fills in the nodes of `map`, number `index` among the maps of all lights.
  void run(const Scene& scene, const build::DeviceScene& deviceScene, const technique::ShadowTechnique& technique,
           std::size_t index, LightMap& map);

 private:
  device::Device& device_;
  device::Scan scan_;
};

}  // namespace cdsm::render
