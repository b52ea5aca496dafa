// SPDX-License-Identifier: Apache-2.0
#include "frame_times.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <cdsm/error.hpp>

namespace cdsm::cli {
namespace {

constexpr double kLeastMs = 1e-3;  // where noise is more than what is measured; ratios and logarithms need some
constexpr float kNudge = 1e-5f;    // relative: enough to build maps again, too little to be seen

Light nudged(Light light, float by) {
  light.cutoff *= 1.0f + by;
  if (light.type == LightType::Omni) light.position.x += by * std::max(1.0f, glm::length(light.position));
  if (light.type == LightType::Directional) light.direction.x += by * glm::length(light.direction);
  return light;
}

}  // namespace

std::size_t mapCount(const FrameStats& stats) {
  std::size_t count = 0;
  for (const LightStats& light : stats.lights) count += light.maps.size();
  return count;
}

std::size_t builtMaps(const FrameStats& stats) {
  std::size_t count = 0;
  for (const LightStats& light : stats.lights)
    for (const MapStats& map : light.maps) count += map.regenerated;
  return count;
}

double renderMs(Engine& engine, const Scene& scene) {
  const auto begun = std::chrono::steady_clock::now();
  engine.render(scene);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

void nudgeLights(Scene& scene, bool& nudgedBefore) {
  nudgedBefore = !nudgedBefore;
  for (Light& light : scene.lights) light = nudged(light, nudgedBefore ? kNudge : -kNudge);
}

double buildMs(Engine& engine, Scene& scene, bool& nudgedBefore) {
  Scene tiny = shrunk(scene);
  engine.render(tiny);
  const double kept = renderMs(engine, tiny);
  nudgeLights(scene, nudgedBefore);
  tiny.lights = scene.lights;
  const double built = renderMs(engine, tiny);
  if (builtMaps(engine.stats()) < mapCount(engine.stats()))
    throw Error("maps were kept that must be built to be timed");
  return std::max(built - kept, kLeastMs);
}

Scene shrunk(Scene scene) {
  scene.image.width = 3;
  scene.image.height = 2;
  return scene;
}

}  // namespace cdsm::cli
