// SPDX-License-Identifier: Apache-2.0
#include "scene/view.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace cdsm::scene {

void Bounds::add(const glm::vec3& point) {
  low = glm::min(low, point);
  high = glm::max(high, point);
}

void Bounds::add(const Bounds& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

bool Bounds::contains(const glm::vec3& point) const {
  return glm::all(glm::lessThanEqual(low, point)) && glm::all(glm::lessThanEqual(point, high));
}

float Bounds::diagonal() const { return low.x <= high.x ? glm::length(high - low) : 0.0f; }

glm::mat4 worldFromIndex(const Volume& volume) { return volume.worldFromObject * volume.data->objectFromIndex; }

Bounds boundsOf(const MeshData& data, const glm::mat4& worldFromObject) {
  Bounds bounds;
  for (const glm::vec3& p : data.positions) bounds.add(glm::vec3(worldFromObject * glm::vec4(p, 1.0f)));
  return bounds;
}

float scaleOf(const glm::mat4& matrix) { return glm::length(glm::vec3(matrix[0])); }

Bounds boundsOf(const SphereData& data, const glm::mat4& worldFromObject) {
  Bounds bounds;
  const float scale = scaleOf(worldFromObject);
  for (std::size_t i = 0; i < data.centers.size(); ++i) {
    const glm::vec3 center(worldFromObject * glm::vec4(data.centers[i], 1.0f)), reach(scale * data.radii[i]);
    bounds.add({center - reach, center + reach});
  }
  return bounds;
}

Bounds worldBounds(const Scene& scene) {
  Bounds bounds;
  for (const Mesh& mesh : scene.meshes) bounds.add(boundsOf(*mesh.data, mesh.worldFromObject));
  for (const Spheres& spheres : scene.spheres) bounds.add(boundsOf(*spheres.data, spheres.worldFromObject));
  for (const Volume& volume : scene.volumes) {
    const glm::mat4 matrix = worldFromIndex(volume);
    const glm::vec3 size(volume.data->size);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 unit(corner & 1, corner >> 1 & 1, corner >> 2);
      bounds.add(glm::vec3(matrix * glm::vec4(unit * size - 0.5f, 1.0f)));
    }
  }
  return bounds;
}

namespace {

/// Nothing nearer to the camera than this part of the scene's size is seen, or of the way to the target if that is
/// less: a wide floor must not hide what stands on it.
constexpr float kNearPart = 1e-5f;

/// Sizes, and what else views of any kind share.
shared::ViewData viewOfSize(int width, int height, float nearDepth) {
  shared::ViewData view{};
  view.width = width;
  view.height = height;
  view.tilesX = (width + CDSM_TILE - 1) / CDSM_TILE;
  view.tilesY = (height + CDSM_TILE - 1) / CDSM_TILE;
  view.nearDepth = nearDepth;
  return view;
}

}  // namespace

shared::ViewData perspectiveView(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& up, float tanX,
                                 float tanY, int width, int height, float nearDepth) {
  const glm::vec3 right = glm::normalize(glm::cross(forward, up));
  const glm::vec3 down = glm::cross(forward, right);
  // u = (right.p / depth / tanX + 1) * width / 2, times depth; v likewise
  const float scaleX = 0.5f * float(width) / tanX, scaleY = 0.5f * float(height) / tanY;
  const glm::vec3 rowU = right * scaleX + forward * (0.5f * float(width));
  const glm::vec3 rowV = down * scaleY + forward * (0.5f * float(height));
  shared::ViewData view = viewOfSize(width, height, nearDepth);
  view.pixelU = {rowU, -glm::dot(rowU, eye)};
  view.pixelV = {rowV, -glm::dot(rowV, eye)};
  view.pixelW = view.depth = {forward, -glm::dot(forward, eye)};
  view.origin = {eye, 0.0f};
  view.dir = {forward - right * tanX - down * tanY, 0.0f};
  view.dirU = {right / scaleX, 0.0f};
  view.dirV = {down / scaleY, 0.0f};
  return view;
}

shared::ViewData parallelView(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& right, float halfX,
                              float halfY, int width, int height) {
  const glm::vec3 down = glm::cross(forward, right);
  const float scaleX = 0.5f * float(width) / halfX, scaleY = 0.5f * float(height) / halfY;
  shared::ViewData view = viewOfSize(width, height, 0.0f);
  view.pixelU = {right * scaleX, 0.5f * float(width) - glm::dot(right * scaleX, eye)};
  view.pixelV = {down * scaleY, 0.5f * float(height) - glm::dot(down * scaleY, eye)};
  view.pixelW = {0.0f, 0.0f, 0.0f, 1.0f};
  view.depth = {forward, -glm::dot(forward, eye)};
  view.origin = {eye - right * halfX - down * halfY, 0.0f};
  view.originU = {right / scaleX, 0.0f};
  view.originV = {down / scaleY, 0.0f};
  view.dir = {forward, 0.0f};
  return view;
}

float cameraNearDepth(const Camera& camera, const Bounds& bounds) {
  const float viewLength = glm::distance(camera.position, camera.target);
  return std::max(kNearPart * std::min(bounds.diagonal(), viewLength), 1e-20f);
}

shared::ViewData cameraView(const Camera& camera, int width, int height, float nearDepth) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const float tanY = std::tan(glm::radians(camera.fov) * 0.5f);
  return perspectiveView(camera.position, forward, camera.up, tanY * float(width) / float(height), tanY, width, height,
                         nearDepth);
}

}  // namespace cdsm::scene
