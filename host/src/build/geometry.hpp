// SPDX-License-Identifier: Apache-2.0
// The triangles of all objects on the device, in object space. Moving objects does not touch them.
#pragma once

#include <memory>
#include <vector>

#include <cdsm/scene.hpp>

#include "device/buffer.hpp"
#include "shared/types.h"

namespace cdsm::build {

/// The triangles of one object. `flip`: with their corners in the other order.
struct ObjectTriangles {
  std::shared_ptr<const MeshData> data;
  bool flip = false;

  bool operator==(const ObjectTriangles& other) const { return data == other.data && flip == other.flip; }
};

/// Triangles, or spheres, first .. first + count - 1.
struct PrimitiveRange {
  std::size_t first = 0, count = 0;
};

class Geometry {
 public:
  explicit Geometry(device::Device& device) : device_(device) {}

  /// Uploads the triangles of the objects, in their order, unless they are what is there already.
  void update(std::vector<ObjectTriangles> objects);

  const PrimitiveRange& rangeOf(std::size_t object) const { return ranges_[object]; }
  /// Corners, w: object.
  const std::vector<shared::uint4>& hostTriangles() const { return hostTriangles_; }
  const std::vector<float>& hostPositions() const { return hostPositions_; }
  const device::Buffer<shared::uint4>& triangles() const { return triangles_; }
  const device::Buffer<float>& positions() const { return positions_; }
  const device::Buffer<float>& normals() const { return normals_; }

 private:
  void append(const ObjectTriangles& object);

  device::Device& device_;
  std::vector<ObjectTriangles> objects_;
  bool uploaded_ = false;
  std::vector<PrimitiveRange> ranges_;
  std::vector<shared::uint4> hostTriangles_;
  std::vector<float> hostPositions_, hostNormals_;
  device::Buffer<shared::uint4> triangles_;
  device::Buffer<float> positions_, normals_;
};

}  // namespace cdsm::build
