// SPDX-License-Identifier: Apache-2.0
#include "render/query_pass.hpp"

namespace cdsm::render {

std::vector<float> QueryPass::run(const Scene& scene, const build::DeviceScene& deviceScene, std::size_t light,
                                  const std::vector<glm::vec3>& points, const device::Buffer<shared::LightData>& lights,
                                  const technique::ShadowTechnique& technique, const ShadowVolume& cache) {
  using Floats = device::Buffer<float>;
  using QueryKernel = device::Kernel<shared::QueryParams, Floats, Floats, device::Buffer<shared::LightData>,
                                     shared::TechniqueParams, device::ArgumentList, device::ArgumentList>;
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "points are uploaded as they are");
  const auto pointBuffer =
      Floats::fromHost(device_, points.empty() ? nullptr : &points[0].x, 3 * points.size(), "points");
  const Floats values(device_, points.size(), "transmittances");
  const device::Buffer<std::uint32_t> noObjects(device_, 0, "objects around the eye");
  QueryKernel queryPoints(device_,
                          build::sceneProgram(device_, deviceScene, "render/query.cl", cache.kernelFiles(technique)),
                          "queryPoints");
  queryPoints({"query points", {points.size()}, {64}}, {shared::uint(points.size()), shared::uint(light)}, pointBuffer,
              values, lights, technique.params(scene), cache.arguments(technique),
              deviceScene.arguments(deviceScene.allObjects(), noObjects));
  return values.download();
}

}  // namespace cdsm::render
