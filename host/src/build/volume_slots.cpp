// SPDX-License-Identifier: Apache-2.0
#include "build/volume_slots.hpp"

#include "device/program.hpp"
#include "shared/scene_data.h"

namespace cdsm::build {

namespace {

struct ImageFormat {
  cl_channel_type channel;
  const char* scale;  ///< read_imagef's result times this, minus `offset`, is the voxel's value
  const char* offset;
};

/// Signed voxels lie in unsigned images, shifted by half their range: signed images read the two lowest values as one.
ImageFormat imageFormat(VoxelType type) {
  switch (type) {
    case VoxelType::UInt8:
      return {CL_UNORM_INT8, "255.0f", "0.0f"};
    case VoxelType::Int8:
      return {CL_UNORM_INT8, "255.0f", "128.0f"};
    case VoxelType::UInt16:
      return {CL_UNORM_INT16, "65535.0f", "0.0f"};
    case VoxelType::Int16:
      return {CL_UNORM_INT16, "65535.0f", "32768.0f"};
    case VoxelType::Float32:
      break;
  }
  return {CL_FLOAT, "1.0f", "0.0f"};
}

/// Signed voxels plus half their range, which turns their highest bits round.
std::vector<std::byte> shiftedVoxels(const VolumeData& data) {
  std::vector<std::byte> shifted = data.voxels;
  const std::size_t bytes = voxelBytes(data.type);
  for (std::size_t i = bytes - 1; i < shifted.size(); i += bytes) shifted[i] ^= std::byte(0x80);
  return shifted;
}

device::VolumeTexture makeTexture(device::Device& device, const VolumeData& data) {
  const bool isSigned = data.type == VoxelType::Int8 || data.type == VoxelType::Int16;
  const std::vector<std::byte> shifted = isSigned ? shiftedVoxels(data) : std::vector<std::byte>();
  return device::VolumeTexture(device, imageFormat(data.type).channel, {data.size.x, data.size.y, data.size.z},
                               isSigned ? shifted.data() : data.voxels.data(), data.voxels.size(), "voxels");
}

shared::int4 int4Of(const glm::uvec3& v) { return {int(v.x), int(v.y), int(v.z), 0}; }

}  // namespace

glm::uvec3 cellCounts(const VolumeData& data) {
  return (data.size + unsigned(CDSM_MACROCELL - 1)) / unsigned(CDSM_MACROCELL);
}

const char* voxelTypeName(VoxelType type) {
  switch (type) {
    case VoxelType::UInt8:
      return "uchar";
    case VoxelType::Int8:
      return "char";
    case VoxelType::UInt16:
      return "ushort";
    case VoxelType::Int16:
      return "short";
    case VoxelType::Float32:
      break;
  }
  return "float";
}

std::shared_ptr<VoxelSlot> VolumeSlots::makeSlot(const std::shared_ptr<const VolumeData>& data) {
  const std::uint64_t voxels = std::uint64_t(data->size.x) * data->size.y * data->size.z;
  if (voxels > 0x7fffffffu)
    throw DeviceError("a volume has " + std::to_string(voxels) +
                      " voxels, more than 2^31 - 1; cut it into several volumes");
  auto slot = std::make_shared<VoxelSlot>();
  slot->data = data;
  slot->voxels = device::Buffer<std::byte>::fromHost(device_, data->voxels, "voxels");
  const glm::uvec3 cells = cellCounts(*data);
  const std::size_t count = std::size_t(cells.x) * cells.y * cells.z;
  slot->cellBounds = device::Buffer<shared::float2>(device_, count, "bounds of macrocells");
  const cl::Program& program =
      device_.programs().get({"build/cell_bounds.cl", {{"CDSM_VOXEL", voxelTypeName(data->type)}}, {}});
  device::Kernel<shared::int4, shared::int4, device::Buffer<std::byte>, device::Buffer<shared::float2>> cellBounds(
      device_, program, "cellBounds");
  cellBounds({"macrocell bounds", {count}, {64}}, int4Of(data->size), int4Of(cells), slot->voxels, slot->cellBounds);
  if (device_.fetchImages()) {
    device_.finish();
    slot->voxels = {};
    slot->texture = makeTexture(device_, *data);
  }
  return slot;
}

void VolumeSlots::update(const std::vector<Volume>& volumes) {
  std::vector<std::shared_ptr<VoxelSlot>> slots;
  std::map<const VolumeData*, int> numbers;
  for (const Volume& volume : volumes) {
    if (!numbers.emplace(volume.data.get(), int(slots.size())).second) continue;
    const auto known = numbers_.find(volume.data.get());
    slots.push_back(known != numbers_.end() ? slots_[known->second] : nullptr);
  }
  // forget what is no longer used before anything new needs the room
  slots_ = std::move(slots);
  numbers_ = std::move(numbers);
  try {
    for (const Volume& volume : volumes) {
      auto& slot = slots_[numbers_.at(volume.data.get())];
      if (!slot) slot = makeSlot(volume.data);
    }
  } catch (...) {
    slots_.clear();
    numbers_.clear();
    throw;
  }
}

std::string VolumeSlots::kernelFile() const {
  const bool images = device_.fetchImages();
  std::string params, args, values, batches, gradients;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const VoxelType type = slots_[i]->data->type;
    const std::string name = "volume" + std::to_string(i);
    const std::string typeName = voxelTypeName(type);
    const std::string label = i + 1 < slots_.size() ? "case " + std::to_string(i) : "default";
    params += images ? ", __read_only image3d_t " + name : ", __global const " + typeName + "* " + name;
    args += ", " + name;
    const ImageFormat format = imageFormat(type);
    const std::string tail =
        images ? "(" + name + ", " + format.scale + ", p)" : "_" + typeName + "(" + name + ", size, p)";
    const std::string shift = images ? " - " + std::string(format.offset) : "";
    const std::string shiftW = images ? " - (float4)(0.0f, 0.0f, 0.0f, " + std::string(format.offset) + ")" : "";
    values += label + ": return " + (images ? "imageValue" : "value") + tail + shift + "; ";
    batches += label + ": return " + (images ? "imageValues" : "values") + tail + shift + "; ";
    gradients += label + ": return " + (images ? "imageGradient" : "gradient") + tail + shiftW + "; ";
  }
  const bool none = slots_.empty();
  return "#define CDSM_VOLUME_PARAMS " + params + "\n#define CDSM_VOLUME_ARGS " + args +
         "\n#define CDSM_VOLUME_VALUES " + (none ? "return 0.0f;" : "switch (slot) { " + values + "}") +
         "\n#define CDSM_VOLUME_BATCHES " + (none ? "return (floatN)(0.0f);" : "switch (slot) { " + batches + "}") +
         "\n#define CDSM_VOLUME_GRADIENTS " + (none ? "return (float4)(0.0f);" : "switch (slot) { " + gradients + "}") +
         "\n";
}

device::ArgumentList VolumeSlots::arguments() const {
  device::ArgumentList list;
  for (const auto& slot : slots_) {
    if (device_.fetchImages())
      list.push_back(slot->texture.image());
    else
      list.push_back(slot->voxels.cl());
  }
  return list;
}

}  // namespace cdsm::build
