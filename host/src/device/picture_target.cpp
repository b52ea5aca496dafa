// SPDX-License-Identifier: Apache-2.0
#include "device/picture_target.hpp"

#include "device/cl_error.hpp"

namespace cdsm::device {

namespace {

constexpr std::size_t kPixelBytes = 4 * sizeof(float);

/// Empty, or why the memory cannot hold such a picture.
std::string obstacle(const cl::Memory& memory, std::size_t width, std::size_t height) {
  const std::string wanted = std::to_string(width) + " x " + std::to_string(height);
  if (memory.getInfo<CL_MEM_TYPE>() == CL_MEM_OBJECT_BUFFER) {
    const std::size_t has = memory.getInfo<CL_MEM_SIZE>(), needed = width * height * kPixelBytes;
    return has >= needed ? "" : "has " + std::to_string(has) + " bytes, must have " + std::to_string(needed);
  }
  if (memory.getInfo<CL_MEM_TYPE>() != CL_MEM_OBJECT_IMAGE2D) return "must be a buffer or a 2D image";
  const cl::Image2D image(static_cast<cl_mem>(memory()), true);
  const cl_image_format format = image.getImageInfo<CL_IMAGE_FORMAT>();
  if (format.image_channel_order != CL_RGBA || format.image_channel_data_type != CL_FLOAT)
    return "is an image of another format, must be CL_RGBA of CL_FLOAT";
  const std::size_t w = image.getImageInfo<CL_IMAGE_WIDTH>(), h = image.getImageInfo<CL_IMAGE_HEIGHT>();
  return w == width && h == height
             ? ""
             : "is an image of " + std::to_string(w) + " x " + std::to_string(h) + " pixels, must have " + wanted;
}

}  // namespace

PictureTarget::PictureTarget(Device& device, cl_mem memory, int width, int height)
    : device_(device), width_(std::size_t(width)), height_(std::size_t(height)) {
  const std::string what = "the memory given for the image ";
  if (!memory) throw DeviceError(what + "is null");
  guarded(what, [&] {
    memory_ = cl::Buffer(memory, true);
    if (memory_.getInfo<CL_MEM_CONTEXT>()() != device.context()())
      throw DeviceError(what + "is of another context, must be of the engine's (opencl::placeOf)");
    const std::string reason = obstacle(memory_, width_, height_);
    if (!reason.empty()) throw DeviceError(what + reason);
    isImage_ = memory_.getInfo<CL_MEM_TYPE>() != CL_MEM_OBJECT_BUFFER;
  });
}

void PictureTarget::write(const void* pixels) {
  cl::Event event;
  guarded("writing the image", [&] {
    if (isImage_)
      device_.queue().enqueueWriteImage(cl::Image2D(memory_(), true), CL_TRUE, {0, 0, 0}, {width_, height_, 1}, 0, 0,
                                        pixels, nullptr, &event);
    else
      device_.queue().enqueueWriteBuffer(cl::Buffer(memory_(), true), CL_TRUE, 0, width_ * height_ * kPixelBytes,
                                         pixels, nullptr, &event);
  });
  device_.profiler().record("upload image", event, {width_ * height_ * kPixelBytes});
}

}  // namespace cdsm::device
