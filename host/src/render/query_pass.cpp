// SPDX-License-Identifier: Apache-2.0
#include "render/query_pass.hpp"

namespace cdsm::render {

namespace {

constexpr std::size_t kMostPoints = std::size_t(1) << 31;  ///< whole groups of work items are counted in 32 bits

}  // namespace

void QueryPass::run(const QueryScene& in, std::size_t light, const DevicePoints& points, const Floats& values) {
  if (points.count > kMostPoints)
    throw Error("a query of " + std::to_string(points.count) + " points, must be at most " +
                std::to_string(kMostPoints) + "; ask for them in parts");
  if (!queryPoints_)
    queryPoints_.emplace(
        device_, build::sceneProgram(device_, in.deviceScene, "render/query.cl", in.cache.kernelFiles(in.technique)),
        "queryPoints");
  const shared::QueryParams params{shared::uint(points.count), shared::uint(light), shared::uint(points.stride), 0};
  (*queryPoints_)({"query points", {points.count}, {64}}, params, points.coordinates, values, in.lights,
                  in.technique.params(in.scene), in.cache.arguments(in.technique),
                  in.deviceScene.arguments(in.deviceScene.allObjects(), noObjects_));
}

void QueryPass::run(const QueryScene& in, std::size_t light, const glm::vec3* points, std::size_t count,
                    float* values) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "points are uploaded as they are");
  if (count == 0) return;
  const float* first = &points->x;
  const std::size_t valueCount = in.deviceScene.spectrum().channels * count;
  const bool inPlace =
      Floats::canBeInPlace(device_, first, 3 * count) && Floats::canBeInPlace(device_, values, valueCount);
  if (!inPlace) {
    const Floats results(device_, valueCount, "transmittances");
    run(in, light, {Floats::fromHost(device_, first, 3 * count, "points"), count}, results);
    return results.download(values);
  }
  const Floats results = Floats::inPlace(device_, values, valueCount, "transmittances");
  run(in, light, {Floats::inPlace(device_, first, 3 * count, "points"), count}, results);
  results.toHost();
}

device::LookupArguments QueryPass::arguments(const QueryScene& in) const {
  device::LookupArguments arguments;
  arguments.addMemory(in.lights.cl());
  arguments.addValue(in.technique.params(in.scene));
  for (const cl::Memory& memory : in.cache.arguments(in.technique)) arguments.addMemory(memory);
  for (const cl::Memory& memory : in.deviceScene.arguments(in.deviceScene.allObjects(), noObjects_))
    arguments.addMemory(memory);
  return arguments;
}

}  // namespace cdsm::render
