// SPDX-License-Identifier: Apache-2.0
#include "scene/voxels.hpp"

#include <cstring>

namespace cdsm::scene {

HostVoxels hostVoxels(const VolumeData& data) {
  const auto bytes = std::ptrdiff_t(voxelBytes(data.type));
  const std::array<std::ptrdiff_t, 3> dense{bytes, bytes * data.size.x, bytes * data.size.x * data.size.y};
  if (!data.view.data) return {data.voxels.data(), dense, true};
  const auto* first = static_cast<const std::byte*>(data.view.data);
  if (data.view.strides == std::array<std::ptrdiff_t, 3>{0, 0, 0}) return {first, dense, true};
  HostVoxels voxels{first, data.view.strides, true};
  // of an axis with one voxel the stride says nothing
  for (int axis = 0; axis < 3; ++axis)
    voxels.dense = voxels.dense && (data.size[axis] == 1 || voxels.strides[axis] == dense[axis]);
  return voxels;
}

std::size_t voxelCount(const VolumeData& data) { return std::size_t(data.size.x) * data.size.y * data.size.z; }

std::vector<std::byte> packedVoxels(const VolumeData& data) {
  const HostVoxels voxels = hostVoxels(data);
  const std::size_t bytes = voxelBytes(data.type);
  std::vector<std::byte> packed(voxelCount(data) * bytes);
  if (voxels.dense) {
    std::memcpy(packed.data(), voxels.first, packed.size());
    return packed;
  }
  std::byte* to = packed.data();
  for (std::size_t z = 0; z < data.size.z; ++z)
    for (std::size_t y = 0; y < data.size.y; ++y)
      for (std::size_t x = 0; x < data.size.x; ++x, to += bytes) std::memcpy(to, voxels.at(x, y, z), bytes);
  return packed;
}

}  // namespace cdsm::scene
