// SPDX-License-Identifier: Apache-2.0
// Images for volumes and nodes. In: host voxels, or a buffer of nodes; out: checked images, profiled transfers.
#include "device/texture.hpp"

#include <algorithm>
#include <vector>

#include "device/cl_error.hpp"

namespace cdsm::device {
namespace {

constexpr std::size_t kNodeTexelBytes = 16;

std::size_t channelBytes(cl_channel_type type) {
  switch (type) {
    case CL_UNORM_INT8:
      return 1;
    case CL_UNORM_INT16:
      return 2;
    case CL_FLOAT:
      return 4;
    default:
      throw DeviceError("a volume texture of an unknown channel type; UNORM of 8 or 16 bits or FLOAT are known");
  }
}

bool supportsFormat(const Device& device, cl_mem_object_type object, const cl::ImageFormat& wanted) {
  std::vector<cl::ImageFormat> formats;
  device.context().getSupportedImageFormats(CL_MEM_READ_ONLY, object, &formats);
  return std::any_of(formats.begin(), formats.end(), [&](const cl::ImageFormat& format) {
    return format.image_channel_order == wanted.image_channel_order &&
           format.image_channel_data_type == wanted.image_channel_data_type;
  });
}

std::string sizeText(const VolumeTexture::Size& size) {
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

VolumeTexture::Size sizeOf(const cl::Image3D& image) {
  return {image.getImageInfo<CL_IMAGE_WIDTH>(), image.getImageInfo<CL_IMAGE_HEIGHT>(),
          image.getImageInfo<CL_IMAGE_DEPTH>()};
}

std::string obstacle3d(const Device& device, cl_channel_type type, const VolumeTexture::Size& size) {
  const VolumeTexture::Size most{device.handle().getInfo<CL_DEVICE_IMAGE3D_MAX_WIDTH>(),
                                 device.handle().getInfo<CL_DEVICE_IMAGE3D_MAX_HEIGHT>(),
                                 device.handle().getInfo<CL_DEVICE_IMAGE3D_MAX_DEPTH>()};
  for (std::size_t axis = 0; axis < size.size(); ++axis) {
    if (size[axis] >= 1 && size[axis] <= most[axis]) continue;
    return "a 3D image of " + sizeText(size) + " voxels, but the device's have 1 to " + sizeText(most);
  }
  if (!supportsFormat(device, CL_MEM_OBJECT_IMAGE3D, cl::ImageFormat(CL_R, type))) {
    return "the device has no 3D images of one channel of this type";
  }
  return "";
}

}  // namespace

std::string VolumeTexture::obstacle(const Device& device, cl_channel_type type, const Size& size) {
  if (!device.description().images) return "the device has no images";
  return guarded("asking for image formats", [&] { return obstacle3d(device, type, size); });
}

VolumeTexture::VolumeTexture(Device& device, cl_channel_type type, const Size& size, std::size_t bytes,
                             const std::string& name)
    : size_(size) {
  const std::string what = "texture '" + name + "'";
  const std::string reason = obstacle(device, type, size);
  if (!reason.empty()) throw DeviceError(what + ": " + reason);
  const std::size_t needed = size[0] * size[1] * size[2] * channelBytes(type);
  if (bytes != needed) {
    throw DeviceError(what + ": " + std::to_string(bytes) + " bytes given, but " + sizeText(size) + " voxels need " +
                      std::to_string(needed));
  }
  claim_ = MemoryClaim(device.account(), bytes, what);
  guarded(what + " of " + std::to_string(bytes) + " bytes", [&] {
    image_ = cl::Image3D(device.context(), CL_MEM_READ_ONLY, cl::ImageFormat(CL_R, type), size[0], size[1], size[2]);
  });
}

VolumeTexture::VolumeTexture(Device& device, cl_channel_type type, const Size& size, const void* voxels,
                             std::size_t bytes, const std::string& name)
    : VolumeTexture(device, type, size, bytes, name) {
  cl::Event event;
  guarded("upload of texture '" + name + "'", [&] {
    device.queue().enqueueWriteImage(image_, CL_TRUE, {0, 0, 0}, size, 0, 0, voxels, nullptr, &event);
  });
  device.profiler().record("upload " + name, event, {bytes});
}

VolumeTexture::VolumeTexture(Device& device, cl_channel_type type, const Size& size, const Buffer<std::byte>& voxels,
                             const std::string& name)
    : VolumeTexture(device, type, size, voxels.bytes(), name) {
  cl::Event event;
  guarded("fill of texture '" + name + "'", [&] {
    device.queue().enqueueCopyBufferToImage(voxels.cl(), image_, 0, {0, 0, 0}, size, nullptr, &event);
  });
  device.profiler().record("fill " + name, event, {voxels.bytes()});
}

VolumeTexture VolumeTexture::adopt(const cl::Image3D& image) {
  VolumeTexture texture;
  texture.image_ = image;
  texture.size_ = sizeOf(image);
  return texture;
}

std::optional<cl::Image3D> givenImage(const Device& device, cl_mem memory, const std::string& name) {
  return guarded("the memory given as '" + name + "'", [&]() -> std::optional<cl::Image3D> {
    const cl::Image3D image(memory, true);
    if (image.getInfo<CL_MEM_TYPE>() != CL_MEM_OBJECT_IMAGE3D) return std::nullopt;
    requireContext(device, image, "the memory given as '" + name + "'");
    return image;
  });
}

Buffer<std::byte> copyOf(Device& device, const cl::Image3D& image, const VolumeTexture::Size& size,
                         std::size_t voxelBytes, const std::string& name) {
  const std::size_t pixelBytes = image.getImageInfo<CL_IMAGE_ELEMENT_SIZE>();
  if (size != sizeOf(image) || voxelBytes != pixelBytes)
    throw DeviceError("the image given as '" + name + "' has " + sizeText(sizeOf(image)) + " voxels of " +
                      std::to_string(pixelBytes) + " bytes, must have " + sizeText(size) + " of " +
                      std::to_string(voxelBytes));
  Buffer<std::byte> voxels(device, size[0] * size[1] * size[2] * voxelBytes, name);
  cl::Event event;
  guarded("copy of image '" + name + "'", [&] {
    device.queue().enqueueCopyImageToBuffer(image, voxels.cl(), {0, 0, 0}, size, 0, nullptr, &event);
  });
  device.profiler().record("copy " + name, event, {voxels.bytes()});
  return voxels;
}

std::array<std::size_t, 2> NodeTexture::maxSize(const Device& device) {
  if (!device.description().images) return {0, 0};
  return guarded("asking for image sizes", [&] {
    return std::array<std::size_t, 2>{device.handle().getInfo<CL_DEVICE_IMAGE2D_MAX_WIDTH>(),
                                      device.handle().getInfo<CL_DEVICE_IMAGE2D_MAX_HEIGHT>()};
  });
}

NodeTexture::NodeTexture(Device& device, std::size_t width, std::size_t height, const std::string& name, PixelType type)
    : device_(&device), name_(name), width_(width), height_(height) {
  const std::string what = "texture '" + name + "'";
  const auto most = maxSize(device);
  if (width < 1 || height < 1 || width > most[0] || height > most[1]) {
    throw DeviceError(what + ": " + std::to_string(width) + " x " + std::to_string(height) +
                      " texels asked for, but the device's 2D images have 1 x 1 to " + std::to_string(most[0]) + " x " +
                      std::to_string(most[1]));
  }
  const cl::ImageFormat format(CL_RGBA, type == PixelType::Floats ? CL_FLOAT : CL_UNSIGNED_INT32);
  guarded(what, [&] {
    if (!supportsFormat(device, CL_MEM_OBJECT_IMAGE2D, format)) {
      throw DeviceError(what + ": the device has no 2D images of four channels of 32 bits");
    }
    claim_ = MemoryClaim(device.account(), width * height * kNodeTexelBytes, what);
    image_ = cl::Image2D(device.context(), CL_MEM_READ_ONLY, format, width, height);
  });
}

void NodeTexture::fill(const cl::Buffer& source, std::size_t byteOffset) {
  if (!device_) throw DeviceError("a node texture is filled that was never allocated");
  const std::string doing = "fill of texture '" + name_ + "'";
  cl::Event event;
  guarded(doing, [&] {
    const std::size_t bytes = source.getInfo<CL_MEM_SIZE>();
    const std::size_t needed = width_ * height_ * kNodeTexelBytes;
    if (byteOffset > bytes || needed > bytes - byteOffset) {
      throw DeviceError(doing + ": " + std::to_string(needed) + " bytes from " + std::to_string(byteOffset) +
                        " needed, but the buffer has " + std::to_string(bytes));
    }
    device_->queue().enqueueCopyBufferToImage(source, image_, byteOffset, {0, 0, 0}, {width_, height_, 1}, nullptr,
                                              &event);
  });
  device_->profiler().record("fill " + name_, event, {width_ * height_ * kNodeTexelBytes});
}

}  // namespace cdsm::device
