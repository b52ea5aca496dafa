// SPDX-License-Identifier: Apache-2.0
// Somebody else's memory for a picture: a buffer of four floats a pixel, or an image of such pixels.
#pragma once

#include <CL/opencl.hpp>

#include "device/device.hpp"

namespace cdsm::device {

class PictureTarget {
 public:
  /// Throws DeviceError unless the memory is of the device's context and takes width * height pixels.
  PictureTarget(Device& device, cl_mem memory, int width, int height);

  /// Row after row from the top; blocks.
  void write(const void* pixels);

 private:
  Device& device_;
  cl::Memory memory_;
  bool isImage_ = false;
  std::size_t width_, height_;
};

}  // namespace cdsm::device
