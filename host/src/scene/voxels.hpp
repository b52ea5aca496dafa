// SPDX-License-Identifier: Apache-2.0
// Where the voxels of a volume lie: in it, or in the memory that its view shows.
#pragma once

#include <cstddef>
#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::scene {

/// Voxels in host memory. Strides in bytes along x, y, z.
struct HostVoxels {
  const std::byte* first = nullptr;
  std::array<std::ptrdiff_t, 3> strides{0, 0, 0};
  bool dense = false;  ///< side by side, x fastest

  const std::byte* at(std::size_t x, std::size_t y, std::size_t z) const {
    return first + std::ptrdiff_t(x) * strides[0] + std::ptrdiff_t(y) * strides[1] + std::ptrdiff_t(z) * strides[2];
  }
};

/// Of data that are not in a buffer of the device.
HostVoxels hostVoxels(const VolumeData& data);

std::size_t voxelCount(const VolumeData& data);

/// A copy side by side, x fastest.
std::vector<std::byte> packedVoxels(const VolumeData& data);

}  // namespace cdsm::scene
