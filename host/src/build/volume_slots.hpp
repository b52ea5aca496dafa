// SPDX-License-Identifier: Apache-2.0
// The voxel data of a scene as kernel arguments: one slot per distinct volume, read from buffers or images, and the
// generated kernel file that names them. Programs are specialised to the types of the slots.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <cdsm/scene.hpp>

#include "device/buffer.hpp"
#include "device/kernel.hpp"
#include "device/texture.hpp"
#include "shared/types.h"

namespace cdsm::build {

/// Voxels of one volume on the device, and the bounds of the values in each macrocell.
struct VoxelSlot {
  std::shared_ptr<const VolumeData> data;  ///< kept, so that its address stays its identity
  std::uint64_t revision = 0;              ///< of the data
  device::Buffer<std::byte> voxels;        ///< empty on devices that read images
  device::VolumeTexture texture;
  device::Buffer<shared::float2> cellBounds;
};

/// Macrocells along x, y, z.
glm::uvec3 cellCounts(const VolumeData& data);

/// OpenCL C name of a voxel type.
const char* voxelTypeName(VoxelType type);

class VolumeSlots {
 public:
  explicit VolumeSlots(device::Device& device) : device_(device) {}

  /// Makes one slot per distinct volume of the scene, in the order of their first use. What was uploaded for the last
  /// scene and is still used stays where it is.
  void update(const std::vector<Volume>& volumes);

  int slotOf(const VolumeData* data) const { return numbers_.at(data); }
  const VoxelSlot& slot(int number) const { return *slots_[number]; }

  /// The file "generated/volume_slots.clh" for these slots.
  std::string kernelFile() const;
  /// The kernel arguments that it declares.
  device::ArgumentList arguments() const;

 private:
  std::shared_ptr<VoxelSlot> makeSlot(const Volume& volume);
  /// The voxels where they are if the device can read them there, else a copy.
  device::Buffer<std::byte> makeVoxels(const VolumeData& data) const;
  /// Throws Error for a float voxel in a given buffer that is not finite; others were looked at on the host.
  void requireFinite(const Volume& volume, const device::Buffer<std::byte>& voxels) const;
  void findCellBounds(VoxelSlot& slot) const;

  device::Device& device_;
  std::vector<std::shared_ptr<VoxelSlot>> slots_;
  std::map<const VolumeData*, int> numbers_;
};

}  // namespace cdsm::build
