// SPDX-License-Identifier: Apache-2.0
// Points -> transmittance from one light to each [INTERFACE, 4.6]; the lookup is the renderer's own.
#pragma once

#include <optional>

#include "build/device_scene.hpp"
#include "device/lookup_arguments.hpp"
#include "render/shadow_volume.hpp"
#include "technique/shadow_technique.hpp"

namespace cdsm::render {

/// Points on the device, x y z each.
struct DevicePoints {
  const device::Buffer<float>& coordinates;
  std::size_t count = 0;
  std::size_t stride = 3;  ///< floats from a point to the next
};

/// What queries look up in.
struct QueryScene {
  const Scene& scene;
  const build::DeviceScene& deviceScene;
  const device::Buffer<shared::LightData>& lights;
  const technique::ShadowTechnique& technique;
  const ShadowVolume& cache;
};

class QueryPass {
 public:
  explicit QueryPass(device::Device& device) : device_(device), noObjects_(device, 0, "objects around the eye") {}

  /// Objects or technique have changed: another kernel may be needed.
  void forgetKernel() { queryPoints_.reset(); }

  /// Transmittance of each point, a value per channel, -1 where not lit. `light`: number of the light. Enqueued only.
  void run(const QueryScene& in, std::size_t light, const DevicePoints& points, const device::Buffer<float>& values);
  /// The same from and to host memory, in place where the device shares it.
  void run(const QueryScene& in, std::size_t light, const glm::vec3* points, std::size_t count, float* values);

  /// CDSM_LOOKUP_PARAMS of kernels/device/lookup.clh, in its order.
  device::LookupArguments arguments(const QueryScene& in) const;

 private:
  using Floats = device::Buffer<float>;
  using QueryKernel = device::Kernel<shared::QueryParams, Floats, Floats, device::Buffer<shared::LightData>,
                                     shared::TechniqueParams, device::ArgumentList, device::ArgumentList>;

  device::Device& device_;
  device::Buffer<std::uint32_t> noObjects_;
  std::optional<QueryKernel> queryPoints_;
};

}  // namespace cdsm::render
