// SPDX-License-Identifier: Apache-2.0
// Points -> transmittance from one light to each [INTERFACE, 4.6]; the lookup is the renderer's own.
#pragma once

#include <vector>

#include "build/device_scene.hpp"
#include "render/shadow_volume.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::render {

class QueryPass {
 public:
  explicit QueryPass(device::Device& device) : device_(device) {}

  /// One value per point: transmittance, -1 where not lit. `light`: number of the light.
  std::vector<float> run(const Scene& scene, const build::DeviceScene& deviceScene, std::size_t light,
                         const std::vector<glm::vec3>& points, const device::Buffer<shared::LightData>& lights,
                         const technique::ShadowTechnique& technique, const ShadowVolume& cache);

 private:
  device::Device& device_;
};

}  // namespace cdsm::render
