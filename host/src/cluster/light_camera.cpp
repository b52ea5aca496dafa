// SPDX-License-Identifier: Apache-2.0
#include "cluster/light_camera.hpp"

#include <algorithm>
#include <cmath>

namespace cdsm::cluster {

namespace {

/// Nothing nearer to a spot or omni light than this part of the scene's size casts a shadow.
constexpr float kNearPart = 1e-6f;
/// The image plane of a directional light lies this part of the scene's size in front of it, and its map is not
/// narrower: a scene may be flat.
constexpr float kPlanePart = 1e-3f;
/// More than the rounding of coordinates, as a part of them.
constexpr float kRoundingPart = 1e-6f;

constexpr float kLeast = 1e-20f;  ///< world units, of a scene of one point

glm::vec3 upFor(const glm::vec3& axis) { return std::abs(axis.y) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0); }

shared::ViewData viewAlong(const glm::vec3& axis, const Light& light, float tangent, const scene::Bounds& bounds,
                           int mapSize) {
  const float half = withMargin(tangent, mapSize);
  return scene::perspectiveView(light.position, axis, upFor(axis), half, half, mapSize, mapSize,
                                lightNearDepth(light, bounds));
}

/// The scene as parallel light sees it, around its centre.
struct ParallelSpan {
  glm::vec3 center, halfSize;
  float margin;  ///< world units

  explicit ParallelSpan(const scene::Bounds& bounds) {
    const bool empty = bounds.low.x > bounds.high.x;
    center = empty ? glm::vec3(0.0f) : 0.5f * (bounds.low + bounds.high);
    halfSize = empty ? glm::vec3(0.0f) : 0.5f * (bounds.high - bounds.low);
    margin = std::max({kPlanePart * bounds.diagonal(), kRoundingPart * glm::length(center), kLeast});
  }
  /// Half the extent along a unit vector.
  float along(const glm::vec3& axis) const { return glm::dot(glm::abs(axis), halfSize) + margin; }
};

shared::ViewData parallelView(const Light& light, const scene::Bounds& bounds, int mapSize) {
  const ParallelSpan span(bounds);
  const glm::vec3 forward = glm::normalize(light.direction);
  const glm::vec3 right = glm::normalize(glm::cross(forward, upFor(forward)));
  const glm::vec3 down = glm::cross(forward, right);
  return scene::parallelView(span.center - span.along(forward) * forward, forward, right,
                             withMargin(span.along(right), mapSize), withMargin(span.along(down), mapSize), mapSize,
                             mapSize);
}

}  // namespace

float withMargin(float half, int mapSize) { return half * float(mapSize) / float(mapSize - 2); }

float lightNearDepth(const Light& light, const scene::Bounds& bounds) {
  // a wide floor must not push the near plane into what a spot is aimed at
  const float aim = light.type == LightType::Spot ? glm::distance(light.position, light.target) : INFINITY;
  return std::max(kNearPart * std::min(bounds.diagonal(), aim), kLeast);
}

double planeMargin(double nearest, double farthest) {
  const double rounding = kRoundingPart * std::max(std::abs(nearest), std::abs(farthest));
  return std::max({kPlanePart * (farthest - nearest), rounding, double(kLeast)});
}

float farthestDepth(const shared::ViewData& view, const scene::Bounds& bounds) {
  const glm::vec3 axis(view.depth.x, view.depth.y, view.depth.z);
  const glm::vec3 corner = glm::mix(bounds.low, bounds.high, glm::vec3(glm::greaterThan(axis, glm::vec3(0.0f))));
  return std::max(glm::dot(axis, corner) + view.depth.w, view.nearDepth);
}

std::vector<shared::ViewData> lightViews(const Light& light, const scene::Bounds& bounds, int mapSize) {
  if (light.type == LightType::Directional) return {parallelView(light, bounds, mapSize)};
  if (light.type == LightType::Spot) {
    const glm::vec3 axis = glm::normalize(light.target - light.position);
    return {viewAlong(axis, light, std::tan(glm::radians(light.cutoff)), bounds, mapSize)};
  }
  std::vector<shared::ViewData> views;
  for (int face = 0; face < 6; ++face) {
    glm::vec3 axis(0.0f);
    axis[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
    views.push_back(viewAlong(axis, light, 1.0f, bounds, mapSize));
  }
  return views;
}

shared::LightData lightData(const Light& light, const scene::Bounds& bounds) {
  shared::LightData data{};
  data.position = {light.position, 1.0f};
  data.color = {light.color, 0.0f};
  data.share = 1.0f;
  data.type = CDSM_LIGHT_SPOT;
  if (light.type == LightType::Spot)
    data.axis = {glm::normalize(light.target - light.position), std::tan(glm::radians(light.cutoff))};
  if (light.type == LightType::Omni) data.type = CDSM_LIGHT_OMNI;
  if (light.type == LightType::Directional) {
    const ParallelSpan span(bounds);
    const glm::vec3 toLight = -glm::normalize(light.direction);
    data.type = CDSM_LIGHT_DIRECTIONAL;
    data.position = {toLight, 0.0f};
    data.front = glm::dot(toLight, span.center) + span.along(toLight);
  }
  return data;
}

shared::MapData mapData(const shared::ViewData& view, shared::uint face) {
  shared::MapData map{};
  map.texelU = view.pixelU;
  map.texelV = view.pixelV;
  map.texelW = view.pixelW;
  map.depth = view.depth;
  map.origin = view.origin;
  map.originU = view.originU;
  map.originV = view.originV;
  map.dir = view.dir;
  map.dirU = view.dirU;
  map.dirV = view.dirV;
  map.width = view.width;
  map.height = view.height;
  map.nearDepth = view.nearDepth;
  map.face = face;
  return map;
}

double mapFov(const shared::ViewData& view) {
  const double texel = glm::length(glm::dvec3(view.dirU.x, view.dirU.y, view.dirU.z));  // at distance 1
  return glm::degrees(2.0 * std::atan(0.5 * texel * view.width));
}

}  // namespace cdsm::cluster
