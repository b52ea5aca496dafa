// SPDX-License-Identifier: Apache-2.0
#include "build/volume_slots.hpp"

#include <algorithm>
#include <optional>

#include "device/program.hpp"
#include "scene/voxels.hpp"
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

/// Adds half their range to signed voxels, which turns their highest bits round.
void shift(std::vector<std::byte>& voxels, std::size_t voxelBytes) {
  for (std::size_t i = voxelBytes - 1; i < voxels.size(); i += voxelBytes) voxels[i] ^= std::byte(0x80);
}

device::VolumeTexture::Size sizeOf(const VolumeData& data) { return {data.size.x, data.size.y, data.size.z}; }

cl_mem memoryOf(const VolumeData& data) { return static_cast<cl_mem>(data.view.deviceMemory.get()); }

/// The image that voxels lie in, if they do.
std::optional<cl::Image3D> givenImage(const device::Device& device, const VolumeData& data) {
  return data.view.deviceMemory ? device::givenImage(device, memoryOf(data), "voxels") : std::nullopt;
}

/// Whether kernels can read voxels of somebody else's image as those of textures with this channel.
bool isReadInPlace(const cl::Image3D& image, cl_channel_type channel) {
  const cl_image_format format = image.getImageInfo<CL_IMAGE_FORMAT>();
  return format.image_channel_order == CL_R && format.image_channel_data_type == channel;
}

device::VolumeTexture makeTexture(device::Device& device, const VolumeData& data,
                                  const device::Buffer<std::byte>& buffer) {
  const device::VolumeTexture::Size size = sizeOf(data);
  const cl_channel_type channel = imageFormat(data.type).channel;
  const bool isSigned = data.type == VoxelType::Int8 || data.type == VoxelType::Int16;
  const auto image = givenImage(device, data);
  if (image && !isSigned && isReadInPlace(*image, channel)) return device::VolumeTexture::adopt(*image);
  if (!isSigned) return device::VolumeTexture(device, channel, size, buffer, "voxels");
  std::vector<std::byte> voxels = data.view.deviceMemory ? buffer.download() : scene::packedVoxels(data);
  shift(voxels, voxelBytes(data.type));
  return device::VolumeTexture(device, channel, size, voxels.data(), voxels.size(), "voxels");
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

device::Buffer<std::byte> VolumeSlots::makeVoxels(const VolumeData& data) const {
  using Bytes = device::Buffer<std::byte>;
  const std::size_t bytes = scene::voxelCount(data) * voxelBytes(data.type);
  if (const auto image = givenImage(device_, data))
    return device::copyOf(device_, *image, sizeOf(data), voxelBytes(data.type), "voxels");
  if (data.view.deviceMemory) return Bytes::adopt(device_, memoryOf(data), bytes, "voxels");
  const scene::HostVoxels voxels = scene::hostVoxels(data);
  if (!voxels.dense) {
    device_.profiler().countCopy(bytes);
    return Bytes::fromHost(device_, scene::packedVoxels(data), "voxels");
  }
  const bool aligned = reinterpret_cast<std::uintptr_t>(voxels.first) % voxelBytes(data.type) == 0;
  if (!aligned || !Bytes::canBeInPlace(device_, voxels.first, bytes))
    return Bytes::fromHost(device_, voxels.first, bytes, "voxels");
  return Bytes::inPlace(device_, voxels.first, bytes, "voxels");
}

void VolumeSlots::requireFinite(const Volume& volume, const device::Buffer<std::byte>& voxels) const {
  using Uints = device::Buffer<std::uint32_t>;
  if (!volume.data->view.deviceMemory || volume.data->type != VoxelType::Float32) return;
  const std::size_t count = scene::voxelCount(*volume.data);
  Uints first(device_, 1, "first voxel that is not finite");
  first.fill(~0u);
  device::Kernel<std::uint32_t, device::Buffer<std::byte>, Uints> findNonFinite(
      device_, device_.programs().get({"build/check_voxels.cl", {}, {}}), "findNonFinite");
  findNonFinite({"check voxels", {count}, {64}}, std::uint32_t(count), voxels, first);
  const std::uint32_t bad = first.read(0);
  if (bad != ~0u)
    throw Error("volume '" + volume.name + "': voxel " + std::to_string(bad) + " is not finite, must be a number");
}

void VolumeSlots::findCellBounds(VoxelSlot& slot) const {
  const VolumeData& data = *slot.data;
  const glm::uvec3 cells = cellCounts(data);
  const std::size_t count = std::size_t(cells.x) * cells.y * cells.z;
  slot.cellBounds = device::Buffer<shared::float2>(device_, count, "bounds of macrocells");
  const cl::Program& program =
      device_.programs().get({"build/cell_bounds.cl", {{"CDSM_VOXEL", voxelTypeName(data.type)}}, {}});
  device::Kernel<shared::int4, shared::int4, device::Buffer<std::byte>, device::Buffer<shared::float2>> cellBounds(
      device_, program, "cellBounds");
  cellBounds({"macrocell bounds", {count}, {64}}, int4Of(data.size), int4Of(cells), slot.voxels, slot.cellBounds);
}

std::shared_ptr<VoxelSlot> VolumeSlots::makeSlot(const Volume& volume) {
  const std::size_t voxels = scene::voxelCount(*volume.data);
  if (voxels > 0x7fffffffu)
    throw DeviceError("a volume has " + std::to_string(voxels) +
                      " voxels, more than 2^31 - 1; cut it into several volumes");
  auto slot = std::make_shared<VoxelSlot>();
  slot->data = volume.data;
  slot->voxels = makeVoxels(*volume.data);
  requireFinite(volume, slot->voxels);
  findCellBounds(*slot);
  if (device_.fetchImages()) {
    slot->texture = makeTexture(device_, *volume.data, slot->voxels);
    device_.finish();
    slot->voxels = {};
  }
  return slot;
}

void VolumeSlots::update(const std::vector<Volume>& volumes) {
  std::vector<std::shared_ptr<VoxelSlot>> slots;
  std::map<const VolumeData*, int> numbers;
  for (const Volume& volume : volumes) {
    if (!numbers.emplace(volume.data.get(), int(slots.size())).second) continue;
    const auto known = numbers_.find(volume.data.get());
    const bool same = known != numbers_.end() && slots_[known->second]->revision == volume.revision;
    slots.push_back(same ? slots_[known->second] : nullptr);
  }
  // forget what is no longer used before anything new needs the room
  slots_ = std::move(slots);
  numbers_ = std::move(numbers);
  try {
    for (const Volume& volume : volumes) {
      auto& slot = slots_[numbers_.at(volume.data.get())];
      if (slot) continue;
      slot = makeSlot(volume);
      slot->revision = volume.revision;
    }
  } catch (...) {
    slots_.clear();
    numbers_.clear();
    throw;
  }
}

std::string VolumeSlots::kernelFile() const {
  const bool images = device_.fetchImages();
  std::string params, args, values, batches, gradients, cells;
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
    cells += label + ": return " + (images ? "imageCell" : "cell") + tail + shift + "; ";
  }
  const bool none = slots_.empty();
  return "#define CDSM_VOLUME_PARAMS " + params + "\n#define CDSM_VOLUME_ARGS " + args +
         "\n#define CDSM_VOLUME_VALUES " + (none ? "return 0.0f;" : "switch (slot) { " + values + "}") +
         "\n#define CDSM_VOLUME_BATCHES " + (none ? "return (floatN)(0.0f);" : "switch (slot) { " + batches + "}") +
         "\n#define CDSM_VOLUME_GRADIENTS " + (none ? "return (float4)(0.0f);" : "switch (slot) { " + gradients + "}") +
         "\n#define CDSM_VOLUME_CELLS " + (none ? "return (float8)(0.0f);" : "switch (slot) { " + cells + "}") + "\n";
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
