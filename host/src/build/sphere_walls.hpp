// SPDX-License-Identifier: Apache-2.0
// What lies in front: per tile of a view the depth behind which spheres hide everything.
#pragma once

#include "build/device_scene.hpp"
#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "shared/layer_data.h"
#include "shared/view_data.h"

namespace cdsm::build {

/// Keeps its buffers and lets them grow.
class SphereWalls {
 public:
  explicit SphereWalls(device::Device& device);

  using Uints = device::Buffer<std::uint32_t>;
  using Floats = device::Buffer<float>;

  /// Draws some of the spheres, none if there are few. `leastRadius`: as RasterPass::run() has it.
  void run(const DeviceScene& scene, const ObjectSet& objects, const shared::ViewData& view, float leastRadius = 0.0f);

  /// By number of the scene's spheres: 1 for those that walls of tiles hide.
  const device::Buffer<std::uint8_t>& hidden() const { return hidden_; }

  /// Depths by tile, infinite where something may be seen at any distance.
  const Floats& tiles() const { return walls_; }
  /// The same by pixel, row after row, as the bits of floats.
  const Uints& pixels() const { return depths_; }

 private:
  Uints depths_;
  Floats walls_;
  device::Buffer<std::uint8_t> hidden_;
  device::Kernel<shared::WallParams, shared::ViewData, device::Buffer<shared::SceneSphere>,
                 device::Buffer<shared::ObjectData>, Floats, Uints>
      drawWalls_;
  device::Kernel<shared::ViewData, Uints, Floats> raiseWalls_;
  device::Kernel<shared::SetupParams, shared::ViewData, device::Buffer<shared::SceneSphere>,
                 device::Buffer<shared::ObjectData>, Floats, device::Buffer<std::uint8_t>>
      hideSpheres_;
};

}  // namespace cdsm::build
