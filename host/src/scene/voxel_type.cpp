// SPDX-License-Identifier: Apache-2.0
// Sizes of the voxel types.
#include <cdsm/error.hpp>
#include <cdsm/scene.hpp>

namespace cdsm {

std::size_t voxelBytes(VoxelType type) {
  switch (type) {
    case VoxelType::UInt8:
    case VoxelType::Int8:
      return 1;
    case VoxelType::UInt16:
    case VoxelType::Int16:
      return 2;
    case VoxelType::Float32:
      return 4;
  }
  throw Error("unknown voxel type " + std::to_string(static_cast<int>(type)) + ", must be one of VoxelType's");
}

}  // namespace cdsm
