// SPDX-License-Identifier: Apache-2.0
// Meshes and volumes of the test scenes.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "test_scenes.hpp"

namespace cdsm::reference {
namespace {

constexpr double kPi = 3.14159265358979323846;

void addQuad(MeshParts& mesh, const glm::vec3& center, const glm::vec3& u, const glm::vec3& v) {
  const auto first = static_cast<glm::uint>(mesh.positions.size());
  for (const glm::vec3& p : {center - u - v, center + u - v, center + u + v, center - u + v}) {
    mesh.positions.push_back(p);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

template <typename T>
void appendInteger(std::vector<std::byte>& bytes, double value) {
  const double largest = std::numeric_limits<T>::max();
  const auto number = static_cast<T>(std::lround(std::clamp(value, 0.0, 1.0) * largest));
  const auto* raw = reinterpret_cast<const std::byte*>(&number);
  bytes.insert(bytes.end(), raw, raw + sizeof(T));
}

void appendValue(std::vector<std::byte>& bytes, VoxelType type, double value) {
  switch (type) {
    case VoxelType::UInt8:
      return appendInteger<std::uint8_t>(bytes, value);
    case VoxelType::Int8:
      return appendInteger<std::int8_t>(bytes, value);
    case VoxelType::UInt16:
      return appendInteger<std::uint16_t>(bytes, value);
    case VoxelType::Int16:
      return appendInteger<std::int16_t>(bytes, value);
    case VoxelType::Float32:
      break;
  }
  const auto number = static_cast<float>(value);
  const auto* raw = reinterpret_cast<const std::byte*>(&number);
  bytes.insert(bytes.end(), raw, raw + sizeof(float));
}

/// A number in [0, 1) for a lattice point.
double hashed(int x, int y, int z) {
  auto h = static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u +
           static_cast<std::uint32_t>(z) * 2147483647u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return (h ^ (h >> 16)) / 4294967296.0;
}

double smoothStep(double f) { return f * f * (3.0 - 2.0 * f); }

}  // namespace

MeshData boxMesh(const glm::vec3& low, const glm::vec3& high) {
  MeshParts mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
  }
  const glm::uvec4 faces[6] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const glm::uvec4& f : faces) {
    mesh.triangles.emplace_back(f.x, f.y, f.z);
    mesh.triangles.emplace_back(f.x, f.z, f.w);
  }
  return mesh;
}

MeshData quadMesh(const glm::vec3& center, const glm::vec3& halfU, const glm::vec3& halfV) {
  MeshParts mesh;
  addQuad(mesh, center, halfU, halfV);
  return mesh;
}

MeshData sphereMesh(float radius, int slices, int stacks, bool smooth) {
  MeshParts mesh;
  mesh.positions.emplace_back(0.0f, radius, 0.0f);
  for (int stack = 1; stack < stacks; ++stack) {
    for (int slice = 0; slice < slices; ++slice) {
      const double theta = kPi * stack / stacks;
      const double phi = 2.0 * kPi * slice / slices;
      const glm::dvec3 p(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      mesh.positions.push_back(radius * glm::vec3(p));
    }
  }
  mesh.positions.emplace_back(0.0f, -radius, 0.0f);
  const auto south = static_cast<glm::uint>(mesh.positions.size() - 1);
  const auto at = [&](int stack, int slice) {
    return static_cast<glm::uint>(1 + (stack - 1) * slices + slice % slices);
  };
  for (int slice = 0; slice < slices; ++slice) {
    mesh.triangles.emplace_back(0u, at(1, slice + 1), at(1, slice));
    mesh.triangles.emplace_back(south, at(stacks - 1, slice), at(stacks - 1, slice + 1));
    for (int stack = 1; stack + 1 < stacks; ++stack) {
      mesh.triangles.emplace_back(at(stack, slice), at(stack, slice + 1), at(stack + 1, slice));
      mesh.triangles.emplace_back(at(stack + 1, slice), at(stack, slice + 1), at(stack + 1, slice + 1));
    }
  }
  if (smooth) {
    for (const glm::vec3& p : mesh.positions) mesh.normals.push_back(p / radius);
  }
  return mesh;
}

MeshData stackMesh(int count, float top, float spacing, float half) {
  MeshParts mesh;
  for (int i = 0; i < count; ++i) {
    addQuad(mesh, {0.0f, top - spacing * static_cast<float>(i), 0.0f}, {half, 0.0f, 0.0f}, {0.0f, 0.0f, half});
  }
  return mesh;
}

double largestValue(VoxelType type) {
  switch (type) {
    case VoxelType::UInt8:
      return std::numeric_limits<std::uint8_t>::max();
    case VoxelType::Int8:
      return std::numeric_limits<std::int8_t>::max();
    case VoxelType::UInt16:
      return std::numeric_limits<std::uint16_t>::max();
    case VoxelType::Int16:
      return std::numeric_limits<std::int16_t>::max();
    case VoxelType::Float32:
      break;
  }
  return 1.0;
}

VolumeData makeVolume(VoxelType type, const glm::uvec3& size, const glm::vec3& low, const glm::vec3& high,
                      const Field& field) {
  VolumeData data;
  data.type = type;
  data.size = size;
  const glm::vec3 edge = (high - low) / glm::vec3(size);
  const glm::vec3 first = low + 0.5f * edge;
  for (int axis = 0; axis < 3; ++axis) data.objectFromIndex[axis][axis] = edge[axis];
  data.objectFromIndex[3] = glm::vec4(first, 1.0f);
  for (glm::uint z = 0; z < size.z; ++z) {
    for (glm::uint y = 0; y < size.y; ++y) {
      for (glm::uint x = 0; x < size.x; ++x) {
        appendValue(data.voxels, type, field(glm::dvec3(first) + glm::dvec3(edge) * glm::dvec3(x, y, z)));
      }
    }
  }
  return data;
}

double gaussianBlob(const glm::dvec3& p) { return std::exp(-4.0 * glm::dot(p, p)); }

double noise(const glm::dvec3& p) {
  const glm::dvec3 cell = glm::floor(p);
  const glm::ivec3 c(cell);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    glm::ivec3 at = c;
    for (int axis = 0; axis < 3; ++axis) {
      const double f = smoothStep(p[axis] - cell[axis]);
      const bool upper = (corner >> axis) & 1;
      at[axis] += upper ? 1 : 0;
      weight *= upper ? f : 1.0 - f;
    }
    sum += weight * hashed(at.x, at.y, at.z);
  }
  return sum;
}

double smoke(const glm::dvec3& p) {
  const double octaves = (4.0 * noise(3.0 * p) + 2.0 * noise(6.0 * p + 17.0) + noise(12.0 * p + 31.0)) / 7.0;
  return octaves * std::max(0.0, 1.0 - glm::dot(p, p));
}

}  // namespace cdsm::reference
