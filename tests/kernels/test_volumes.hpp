// SPDX-License-Identifier: Apache-2.0
// Volumes of all voxel types with random voxels, and their trilinear values in double precision.
#pragma once

#include <string>
#include <vector>

#include <cdsm/scene.hpp>

#include "reference/test_scenes.hpp"

namespace cdsm::kernels {

struct TypeRange {
  VoxelType type;
  const char* name;
  double low, high;  ///< values drawn from; of integer types all there are
};

/// All voxel types.
extern const std::vector<TypeRange> kTypes;

/// A grid and its voxels as doubles. Points are voxel coordinates.
struct TestGrid {
  VolumeData data;
  std::vector<double> voxels;

  double value(const glm::dvec3& p) const;
  /// Central differences over two voxels.
  glm::dvec3 gradient(const glm::dvec3& p) const;
};

TestGrid makeGrid(VoxelType type, const glm::uvec3& size, const std::vector<double>& voxels);

/// Every fourth voxel is one of the type's ends.
TestGrid randomGrid(const TypeRange& range, const glm::uvec3& size, std::uint32_t seed);

/// A voxel value that the type can hold.
double storable(VoxelType type, double value);

}  // namespace cdsm::kernels
