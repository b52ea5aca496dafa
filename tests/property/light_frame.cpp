// SPDX-License-Identifier: Apache-2.0
// The geometry of lights' maps, worked out a second time for the tests.
#include "light_frame.hpp"

#include <cmath>

namespace cdsm::property {
namespace {

glm::dvec3 farthestAxis(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  glm::dvec3 result(0.0);
  result[axis] = v[axis] < 0.0 ? -1.0 : 1.0;
  return result;
}

glm::dvec3 axisOf(const Light& light, const glm::dvec3& seen) {
  if (light.type == LightType::Directional) return glm::normalize(glm::dvec3(light.direction));
  if (light.type == LightType::Omni) return farthestAxis(seen - glm::dvec3(light.position));
  return glm::normalize(glm::dvec3(light.target) - glm::dvec3(light.position));
}

struct Box {
  glm::dvec3 low{INFINITY}, high{-INFINITY};

  void add(const glm::dvec4& point) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
};

Box boxOf(const Scene& scene) {
  Box box;
  for (const Mesh& mesh : scene.meshes)
    for (const glm::vec3& p : mesh.data->positions) box.add(glm::dmat4(mesh.worldFromObject) * glm::dvec4(p, 1.0));
  for (const Spheres& spheres : scene.spheres)
    for (std::size_t i = 0; i < spheres.data->centers.size(); ++i) {
      const glm::dmat4 matrix(spheres.worldFromObject);
      const double radius = glm::length(glm::dvec3(matrix[0])) * spheres.data->radii[i];
      const glm::dvec4 center = matrix * glm::dvec4(spheres.data->centers[i], 1.0);
      box.add(center - glm::dvec4(radius));
      box.add(center + glm::dvec4(radius));
    }
  for (const Volume& volume : scene.volumes)
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 unit(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 index = unit * glm::dvec3(volume.data->size) - 0.5;
      box.add(glm::dmat4(volume.worldFromObject) * glm::dmat4(volume.data->objectFromIndex) * glm::dvec4(index, 1.0));
    }
  return box;
}

}  // namespace

LightFrame::LightFrame(const Scene& scene, const Light& light, int mapSize, const glm::dvec3& seen)
    : position_(light.position), mapSize_(mapSize), parallel_(light.type == LightType::Directional) {
  forward_ = axisOf(light, seen);
  const glm::dvec3 hint = std::abs(forward_.y) > 0.99 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  right_ = glm::normalize(glm::cross(forward_, hint));
  up_ = glm::cross(right_, forward_);
  const double margin = mapSize / (mapSize - 2.0);
  halfWidth_ = halfHeight_ =
      margin * (light.type == LightType::Spot ? std::tan(glm::radians(static_cast<double>(light.cutoff))) : 1.0);
  if (!parallel_) return;
  const Box box = boxOf(scene);
  const glm::dvec3 half = 0.5 * (box.high - box.low);
  const double rim = 2e-3 * glm::length(half);
  const auto along = [&](const glm::dvec3& axis) { return glm::dot(glm::abs(axis), half) + rim; };
  halfWidth_ = margin * along(right_);
  halfHeight_ = margin * along(up_);
  position_ = 0.5 * (box.low + box.high) - along(forward_) * forward_;
}

reference::Ray LightFrame::texelRay(int column, int row) const {
  const double x = halfWidth_ * (2.0 * (column + 0.5) / mapSize_ - 1.0);
  const double y = halfHeight_ * (1.0 - 2.0 * (row + 0.5) / mapSize_);
  const glm::dvec3 across = x * right_ + y * up_;
  if (parallel_) return {position_ + across, forward_};
  return {position_, glm::normalize(forward_ + across)};
}

glm::dvec3 LightFrame::point(double x, double y, double depth) const {
  return position_ + depth * forward_ + (parallel_ ? 1.0 : depth) * (x * right_ + y * up_);
}

glm::dvec3 LightFrame::coordinates(const glm::dvec3& pointWorld) const {
  const glm::dvec3 offset = pointWorld - position_;
  const double depth = glm::dot(offset, forward_);
  const double scale = parallel_ ? 1.0 : depth;
  return {glm::dot(offset, right_) / scale, glm::dot(offset, up_) / scale, depth};
}

}  // namespace cdsm::property
