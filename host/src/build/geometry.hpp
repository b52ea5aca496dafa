// SPDX-License-Identifier: Apache-2.0
// The triangles of all objects on the device, in object space. Moving objects does not touch them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <cdsm/scene.hpp>

#include "device/buffer.hpp"
#include "shared/types.h"

namespace cdsm::build {

/// The triangles of one object. `flip`: with their corners in the other order.
struct ObjectTriangles {
  std::shared_ptr<const MeshData> data;
  std::uint64_t revision = 0;  ///< of the data
  bool flip = false;

  bool operator==(const ObjectTriangles& other) const {
    return data == other.data && revision == other.revision && flip == other.flip;
  }
};

/// Triangles, vertices or spheres, first .. first + count - 1.
struct PrimitiveRange {
  std::size_t first = 0, count = 0;
};

class Geometry {
 public:
  explicit Geometry(device::Device& device) : device_(device) {}

  /// Uploads the triangles of the objects, in their order. If as many vertices and triangles come in the same places as
  /// before, only those of objects that have changed.
  void update(std::vector<ObjectTriangles> objects);

  /// Triangles of an object.
  const PrimitiveRange& rangeOf(std::size_t object) const { return triangleRanges_[object]; }
  /// What is on the device.
  const std::vector<ObjectTriangles>& objects() const { return objects_; }
  /// Corners, w: object.
  const device::Buffer<shared::uint4>& triangles() const { return triangles_; }
  const device::Buffer<float>& positions() const { return positions_; }
  /// Of vertices, if their object has normals.
  const device::Buffer<float>& normals() const { return normals_; }

 private:
  bool fit(const std::vector<ObjectTriangles>& objects) const;
  void makeRoom(const std::vector<ObjectTriangles>& objects);
  void upload(std::size_t object, const ObjectTriangles& triangles);

  device::Device& device_;
  std::vector<ObjectTriangles> objects_;
  std::vector<PrimitiveRange> triangleRanges_, vertexRanges_;
  device::Buffer<shared::uint4> triangles_;
  device::Buffer<float> positions_, normals_;
};

}  // namespace cdsm::build
