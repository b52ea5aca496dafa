// SPDX-License-Identifier: Apache-2.0
#include "technique/light_map.hpp"

#include <algorithm>

#include "scene/objects.hpp"

namespace cdsm::technique {

namespace {

constexpr const char* kSides[] = {"+x", "-x", "+y", "-y", "+z", "-z", ""};  // CDSM_LIGHT_OMNI, CDSM_FACE_ANY

glm::vec3 xyz(const shared::float4& v) { return {v.x, v.y, v.z}; }
glm::dvec4 xyzw(const shared::float4& v) { return {v.x, v.y, v.z, v.w}; }

/// The matrix with these rows.
glm::mat4 fromRows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
  return glm::mat4(glm::transpose(glm::dmat4(x, y, z, w)));
}

bool isParallel(const shared::ViewData& view) { return xyz(view.dirU) == glm::vec3(0.0f); }

glm::mat4 pictureFromWorld(const cluster::MapView& map) {
  const shared::ViewData& view = map.view;
  const glm::dvec4 depth = xyzw(view.depth), w = xyzw(view.pixelW), one(0.0, 0.0, 0.0, 1.0);
  const double span = std::max(map.farDepth - map.nearDepth, 1e-6 * map.farDepth);
  const glm::dvec4 behindNear = (depth - map.nearDepth * one) / span;
  return fromRows(xyzw(view.pixelU) / double(view.width), xyzw(view.pixelV) / double(view.height),
                  isParallel(view) ? behindNear : (map.nearDepth + span) * behindNear, w);
}

glm::mat4 cameraFromWorld(const shared::ViewData& view) {
  const bool parallel = isParallel(view);
  const glm::dvec3 right = glm::normalize(glm::dvec3(xyz(parallel ? view.originU : view.dirU)));
  const glm::dvec3 up = -glm::normalize(glm::dvec3(xyz(parallel ? view.originV : view.dirV)));
  const glm::dvec3 eye = glm::dvec3(xyz(view.origin)) + 0.5 * view.width * glm::dvec3(xyz(view.originU)) +
                         0.5 * view.height * glm::dvec3(xyz(view.originV));
  return fromRows({right, -glm::dot(right, eye)}, {up, -glm::dot(up, eye)}, xyzw(view.depth), {0.0, 0.0, 0.0, 1.0});
}

}  // namespace

LightMap describeMap(const Scene& scene, const MapCluster& cluster, std::size_t number) {
  const cluster::MapView& view = cluster.views[number];
  LightMap map;
  map.cluster = int(cluster.number);
  map.number = int(number);
  for (const unsigned object : cluster.objects) map.objects.push_back(scene::objectName(scene, object));
  map.side = kSides[view.face];
  map.width = view.view.width;
  map.height = view.view.height;
  map.nearDepth = float(view.nearDepth);
  map.farDepth = float(view.farDepth);
  map.pictureFromWorld = pictureFromWorld(view);
  map.cameraFromWorld = cameraFromWorld(view.view);
  return map;
}

}  // namespace cdsm::technique
