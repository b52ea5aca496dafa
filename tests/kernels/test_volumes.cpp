// SPDX-License-Identifier: Apache-2.0
// Volumes for the kernel tests.
#include "test_volumes.hpp"

#include <cmath>

namespace cdsm::kernels {
namespace {

template <class T>
void append(std::vector<std::byte>& bytes, double value) {
  const T number = T(value);
  const auto* raw = reinterpret_cast<const std::byte*>(&number);
  bytes.insert(bytes.end(), raw, raw + sizeof(T));
}

void appendVoxel(std::vector<std::byte>& bytes, VoxelType type, double value) {
  switch (type) {
    case VoxelType::UInt8:
      return append<std::uint8_t>(bytes, value);
    case VoxelType::Int8:
      return append<std::int8_t>(bytes, value);
    case VoxelType::UInt16:
      return append<std::uint16_t>(bytes, value);
    case VoxelType::Int16:
      return append<std::int16_t>(bytes, value);
    case VoxelType::Float32:
      return append<float>(bytes, value);
  }
}

}  // namespace

const std::vector<TypeRange> kTypes{{VoxelType::UInt8, "UInt8", 0, 255},
                                    {VoxelType::Int8, "Int8", -128, 127},
                                    {VoxelType::UInt16, "UInt16", 0, 65535},
                                    {VoxelType::Int16, "Int16", -32768, 32767},
                                    {VoxelType::Float32, "Float32", -3.0, 5.0}};

double TestGrid::value(const glm::dvec3& p) const {
  const glm::ivec3 n(data.size);
  const glm::dvec3 base = glm::floor(p), f = p - base;
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 d(i & 1, i >> 1 & 1, i >> 2);
    const glm::ivec3 at = glm::clamp(glm::ivec3(base) + d, glm::ivec3(0), n - 1);
    const double weight = (d.x ? f.x : 1 - f.x) * (d.y ? f.y : 1 - f.y) * (d.z ? f.z : 1 - f.z);
    sum += weight * voxels[(std::size_t(at.z) * n.y + at.y) * n.x + at.x];
  }
  return sum;
}

glm::dvec3 TestGrid::gradient(const glm::dvec3& p) const {
  glm::dvec3 g;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = 1.0;
    g[axis] = value(p + step) - value(p - step);
  }
  return g;
}

double storable(VoxelType type, double value) {
  return type == VoxelType::Float32 ? double(float(value)) : std::round(value);
}

TestGrid makeGrid(VoxelType type, const glm::uvec3& size, const std::vector<double>& voxels) {
  TestGrid grid;
  grid.data.type = type;
  grid.data.size = size;
  grid.voxels = voxels;
  for (const double voxel : voxels) appendVoxel(grid.data.voxels, type, voxel);
  return grid;
}

TestGrid randomGrid(const TypeRange& range, const glm::uvec3& size, std::uint32_t seed) {
  reference::Random random(seed);
  std::vector<double> voxels;
  for (unsigned i = 0; i < size.x * size.y * size.z; ++i) {
    double value = random.uniform(range.low, range.high);
    if (random.uniform(0.0, 1.0) < 0.25) value = random.uniform(0.0, 1.0) < 0.5 ? range.low : range.high;
    voxels.push_back(storable(range.type, value));
  }
  return makeGrid(range.type, size, voxels);
}

}  // namespace cdsm::kernels
