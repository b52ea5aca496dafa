// SPDX-License-Identifier: Apache-2.0
// Copies between buffers on the device.
#pragma once

#include <array>

#include "device/buffer.hpp"
#include "device/cl_error.hpp"

namespace cdsm::device {

/// `count` elements of `from`, from number `first` on, to element `offset` of `to`. Throws DeviceError past an end.
template <class T>
void copyElements(Device& device, const Buffer<T>& from, std::size_t first, std::size_t count, Buffer<T>& to,
                  std::size_t offset) {
  if (count == 0) return;
  if (first + count > from.size() || offset + count > to.size())
    throw DeviceError("copy of " + std::to_string(count) + " elements from '" + from.name() + "' to '" + to.name() +
                      "' reaches past an end");
  cl::Event event;
  guarded("copy of '" + from.name() + "'", [&] {
    device.queue().enqueueCopyBuffer(from.cl(), to.cl(), first * sizeof(T), offset * sizeof(T), count * sizeof(T),
                                     nullptr, &event);
  });
  device.profiler().record("copy " + from.name(), event, {count * sizeof(T)});
}

/// A box of elements in a 3D grid that a buffer holds row after row, slice after slice.
struct GridPlace {
  std::size_t x = 0, y = 0, z = 0;
  std::size_t width = 0, height = 0;  ///< of the whole grid
};

/// `size` elements along x, y and z from one grid to another.
template <class T>
void copyBox(Device& device, const Buffer<T>& from, const GridPlace& source, Buffer<T>& to, const GridPlace& target,
             const std::array<std::size_t, 3>& size) {
  if (size[0] * size[1] * size[2] == 0) return;
  cl::Event event;
  guarded("copy of '" + from.name() + "'", [&] {
    device.queue().enqueueCopyBufferRect(
        from.cl(), to.cl(), {source.x * sizeof(T), source.y, source.z}, {target.x * sizeof(T), target.y, target.z},
        {size[0] * sizeof(T), size[1], size[2]}, source.width * sizeof(T), source.width * source.height * sizeof(T),
        target.width * sizeof(T), target.width * target.height * sizeof(T), nullptr, &event);
  });
  device.profiler().record("copy " + from.name(), event, {size[0] * size[1] * size[2] * sizeof(T)});
}

}  // namespace cdsm::device
