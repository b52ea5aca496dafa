// SPDX-License-Identifier: Apache-2.0
// Meshes and spheres while tests put them together or spoil them: arrays of MeshData and SphereData do not change.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::reference {

struct MeshParts {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;

  operator MeshData() const { return {positions, normals, triangles}; }
};

struct SphereParts {
  std::vector<glm::vec3> centers;
  std::vector<float> radii;
  std::vector<glm::vec3> colors;

  operator SphereData() const { return {centers, radii, colors}; }
};

template <class T>
std::vector<T> valuesOf(const Array<T>& array) {
  return {array.begin(), array.end()};
}

inline MeshParts partsOf(const MeshData& data) {
  return {valuesOf(data.positions), valuesOf(data.normals), valuesOf(data.triangles)};
}

inline SphereParts partsOf(const SphereData& data) {
  return {valuesOf(data.centers), valuesOf(data.radii), valuesOf(data.colors)};
}

}  // namespace cdsm::reference
