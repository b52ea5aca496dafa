// SPDX-License-Identifier: Apache-2.0
// Images to read volumes and map nodes through the texture units. In: host voxels or a buffer of nodes; out: an image
// that was asked for only after the device said that it supports its format and size.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <CL/opencl.hpp>

#include "device/buffer.hpp"
#include "device/device.hpp"
#include "device/memory_account.hpp"

namespace cdsm::device {

/// A read-only image3d_t of one channel (CL_R), x fastest. Move-only.
class VolumeTexture {
 public:
  using Size = std::array<std::size_t, 3>;  ///< voxels along x, y, z, each at least 1

  VolumeTexture() = default;
  /// `type`: CL_UNORM_INT8, CL_UNORM_INT16 or CL_FLOAT; `voxels`: tightly packed,
  /// `bytes` of them. Throws DeviceError with obstacle()'s reason, or when `bytes` is not what size and type need.
  VolumeTexture(Device& device, cl_channel_type type, const Size& size, const void* voxels, std::size_t bytes,
                const std::string& name);
  /// The same of voxels that are on the device already.
  VolumeTexture(Device& device, cl_channel_type type, const Size& size, const Buffer<std::byte>& voxels,
                const std::string& name);

  /// Somebody else's 3D image, retained, which must be of CL_R and one of these types.
  static VolumeTexture adopt(const cl::Image3D& image);

  /// Why the device cannot hold such a texture ("images of at most 2048 x 2048 x 2048 ..."); empty if it can.
  static std::string obstacle(const Device& device, cl_channel_type type, const Size& size);

  const cl::Image3D& image() const { return image_; }
  const Size& size() const { return size_; }

 private:
  /// An image without content. Throws DeviceError where the device has none such.
  VolumeTexture(Device& device, cl_channel_type type, const Size& size, std::size_t bytes, const std::string& name);

  MemoryClaim claim_;
  cl::Image3D image_;
  Size size_{0, 0, 0};
};

/// Somebody else's 3D image, if the memory is one and not a buffer. Throws DeviceError if it is of another context.
std::optional<cl::Image3D> givenImage(const Device& device, cl_mem memory, const std::string& name);

/// The voxels of an image. Throws DeviceError unless they are so many and of so many bytes.
Buffer<std::byte> copyOf(Device& device, const cl::Image3D& image, const VolumeTexture::Size& size,
                         std::size_t voxelBytes, const std::string& name);

/// What the 16 bytes of a pixel are: four floats, or four unsigned words of 32 bits.
enum class PixelType { Floats, Words };

/// A read-only image2d_t of CL_RGBA, 16 bytes a texel, filled on the device. Move-only.
class NodeTexture {
 public:
  NodeTexture() = default;
  /// Throws DeviceError when format or size is not supported.
  NodeTexture(Device& device, std::size_t width, std::size_t height, const std::string& name,
              PixelType type = PixelType::Floats);

  /// The largest {width, height} of a 2D image on the device, in texels; {0, 0} without images.
  static std::array<std::size_t, 2> maxSize(const Device& device);

  /// Copies width * height texels, row after row, from `source` at `byteOffset`.
  void fill(const cl::Buffer& source, std::size_t byteOffset = 0);

  const cl::Image2D& image() const { return image_; }
  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

 private:
  Device* device_ = nullptr;
  std::string name_;
  MemoryClaim claim_;
  cl::Image2D image_;
  std::size_t width_ = 0;
  std::size_t height_ = 0;
};

}  // namespace cdsm::device
