// SPDX-License-Identifier: Apache-2.0
// Copies between buffers on the device.
#pragma once

#include "device/buffer.hpp"
#include "device/cl_error.hpp"

namespace cdsm::device {

/// `count` elements of `from` to element `offset` of `to`. Throws DeviceError past an end.
template <class T>
void copyElements(Device& device, const Buffer<T>& from, std::size_t count, Buffer<T>& to, std::size_t offset) {
  if (count == 0) return;
  if (count > from.size() || offset + count > to.size())
    throw DeviceError("copy of " + std::to_string(count) + " elements from '" + from.name() + "' to '" + to.name() +
                      "' reaches past an end");
  cl::Event event;
  guarded("copy of '" + from.name() + "'", [&] {
    device.queue().enqueueCopyBuffer(from.cl(), to.cl(), 0, offset * sizeof(T), count * sizeof(T), nullptr, &event);
  });
  device.profiler().record("copy " + from.name(), event);
}

}  // namespace cdsm::device
