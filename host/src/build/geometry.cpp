// SPDX-License-Identifier: Apache-2.0
#include "build/geometry.hpp"

#include <cdsm/error.hpp>

namespace cdsm::build {

void Geometry::update(std::vector<ObjectTriangles> objects) {
  if (uploaded_ && objects == objects_) return;
  uploaded_ = false;
  objects_ = std::move(objects);
  ranges_.clear();
  hostTriangles_.clear();
  hostPositions_.clear();
  hostNormals_.clear();
  for (const ObjectTriangles& object : objects_) append(object);
  const auto put = [&](auto& buffer, const auto& values, const char* name) {
    buffer = {};
    buffer = std::decay_t<decltype(buffer)>::fromHost(device_, values, name);
  };
  put(triangles_, hostTriangles_, "triangles");
  put(positions_, hostPositions_, "vertex positions");
  put(normals_, hostNormals_, "vertex normals");
  uploaded_ = true;
}

void Geometry::append(const ObjectTriangles& object) {
  const MeshData& data = *object.data;
  const std::size_t first = hostPositions_.size() / 3;
  if (first + data.positions.size() > 0xffffffffu || hostTriangles_.size() + data.triangles.size() > 0x3fffffffu)
    throw Error("the scene has more than 2^30 triangles or 2^32 vertices, which their numbers cannot hold");
  const auto number = shared::uint(ranges_.size());
  ranges_.push_back({hostTriangles_.size(), data.triangles.size()});
  for (const glm::vec3& p : data.positions) hostPositions_.insert(hostPositions_.end(), {p.x, p.y, p.z});
  for (const glm::vec3& n : data.normals) hostNormals_.insert(hostNormals_.end(), {n.x, n.y, n.z});
  hostNormals_.resize(hostPositions_.size(), 0.0f);
  const auto base = shared::uint(first);
  for (const glm::uvec3& t : data.triangles)
    hostTriangles_.push_back({base + t.x, base + (object.flip ? t.z : t.y), base + (object.flip ? t.y : t.z), number});
}

}  // namespace cdsm::build
