// SPDX-License-Identifier: Apache-2.0
// Fragments of the camera's view -> image [Knecht 2011, §3.3, Alg. 3.3].
#pragma once

#include <vector>

#include "build/device_scene.hpp"
#include "build/raster_pass.hpp"
#include "render/occlusion_pass.hpp"
#include "render/shadow_volume.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::render {

struct ShadedView {
  std::vector<shared::float4> pixels;  ///< rgba, row after row; colour weighted by opacity
  std::vector<std::uint32_t> samples;  ///< of media that were shaded, by pixel
};

/// World units by which surfaces are moved towards the light.
float surfaceBias(const Scene& scene, const build::DeviceScene& deviceScene);

class ShadePass {
 public:
  explicit ShadePass(device::Device& device) : device_(device) {}

  ShadedView run(const Scene& scene, const build::DeviceScene& deviceScene, build::Layers& layers,
                 const device::Buffer<shared::LightData>& lights, const technique::ShadowTechnique& technique,
                 const ShadowVolume& cache, const OcclusionPass& occlusion);

 private:
  device::Device& device_;
  device::Buffer<shared::float4> image_;
  device::Buffer<std::uint32_t> samples_;
};

}  // namespace cdsm::render
