// SPDX-License-Identifier: Apache-2.0
#include "build/geometry.hpp"

#include <utility>

#include <cdsm/error.hpp>

#include "scene/range.hpp"

namespace cdsm::build {

namespace {

/// Into the places of `range`: from where they lie if they lie side by side.
void uploadVectors(device::Buffer<float>& buffer, const Array<glm::vec3>& vectors, const PrimitiveRange& range) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "vectors are floats side by side");
  if (vectors.empty()) return;
  std::vector<glm::vec3> packed;
  const glm::vec3* first = vectors.sideBySide();
  if (!first) {
    packed.reserve(vectors.size());
    packed.assign(vectors.begin(), vectors.end());
    first = packed.data();
  }
  buffer.upload(&first->x, 3 * range.count, 3 * range.first);
}

}  // namespace

void Geometry::update(std::vector<ObjectTriangles> objects) {
  const std::vector<ObjectTriangles> former = std::exchange(objects_, {});  // none should an upload fail
  const bool inPlace = triangles_.allocated() && former.size() == objects.size() && fit(objects);
  if (!inPlace) makeRoom(objects);
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (!inPlace || !(objects[i] == former[i])) upload(i, objects[i]);
  objects_ = std::move(objects);
}

bool Geometry::fit(const std::vector<ObjectTriangles>& objects) const {
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].data->positions.size() != vertexRanges_[i].count ||
        objects[i].data->triangles.size() != triangleRanges_[i].count)
      return false;
  return true;
}

void Geometry::makeRoom(const std::vector<ObjectTriangles>& objects) {
  std::size_t vertices = 0, triangles = 0;
  triangleRanges_.clear();
  vertexRanges_.clear();
  for (const ObjectTriangles& object : objects) {
    vertexRanges_.push_back({vertices, object.data->positions.size()});
    triangleRanges_.push_back({triangles, object.data->triangles.size()});
    vertices += vertexRanges_.back().count;
    triangles += triangleRanges_.back().count;
  }
  if (vertices >= scene::kMostVertices || triangles >= scene::kMostPrimitives)
    throw Error("the scene has more than 2^30 triangles or 2^32 vertices, which their numbers cannot hold");
  triangles_ = {};
  positions_ = {};
  normals_ = {};
  triangles_ = {device_, triangles, "triangles"};
  positions_ = {device_, 3 * vertices, "vertex positions"};
  normals_ = {device_, 3 * vertices, "vertex normals"};
}

void Geometry::upload(std::size_t object, const ObjectTriangles& triangles) {
  const MeshData& data = *triangles.data;
  uploadVectors(positions_, data.positions, vertexRanges_[object]);
  uploadVectors(normals_, data.normals, vertexRanges_[object]);
  const auto base = shared::uint(vertexRanges_[object].first), number = shared::uint(object);
  std::vector<shared::uint4> corners;
  corners.reserve(data.triangles.size());
  for (const glm::uvec3& t : data.triangles)
    corners.push_back({base + t.x, base + (triangles.flip ? t.z : t.y), base + (triangles.flip ? t.y : t.z), number});
  triangles_.upload(corners.data(), corners.size(), triangleRanges_[object].first);
}

}  // namespace cdsm::build
