// SPDX-License-Identifier: Apache-2.0
// Untyped device memory. In: counts and host bytes; out: checked allocations and profiled transfers.
#include "device/buffer.hpp"

#include "device/cl_error.hpp"

namespace cdsm::device {

BufferStorage::BufferStorage(Device& device, std::size_t count, std::size_t elementBytes, std::string name)
    : device_(&device), name_(std::move(name)) {
  allocate(count, elementBytes);
}

void BufferStorage::allocate(std::size_t count, std::size_t elementBytes) {
  const std::size_t elements = count > 0 ? count : 1;
  if (elements > kAll / elementBytes) {
    throw DeviceError("buffer '" + name_ + "': " + std::to_string(elements) + " elements of " +
                      std::to_string(elementBytes) + " bytes asked for, but device '" + device_->description().name +
                      "' allocates at most " + std::to_string(device_->maxAllocationBytes()) + " bytes at once");
  }
  const std::size_t bytes = elements * elementBytes;
  claim_ = MemoryClaim(device_->account(), bytes, "buffer '" + name_ + "'");
  buffer_ = guarded("buffer '" + name_ + "' of " + std::to_string(bytes) + " bytes",
                    [&] { return cl::Buffer(device_->context(), CL_MEM_READ_WRITE, bytes); });
}

void BufferStorage::reallocate(std::size_t count, std::size_t elementBytes) {
  opened();
  buffer_ = cl::Buffer();
  claim_ = MemoryClaim();
  allocate(count, elementBytes);
}

void BufferStorage::write(const void* source, std::size_t bytes, std::size_t offset) {
  if (bytes == 0) return;
  Device& device = opened();
  cl::Event event;
  guarded("upload of buffer '" + name_ + "'",
          [&] { device.queue().enqueueWriteBuffer(buffer_, CL_TRUE, offset, bytes, source, nullptr, &event); });
  device.profiler().record("upload " + name_, event, {bytes});
}

void BufferStorage::read(void* target, std::size_t bytes, std::size_t offset) const {
  if (bytes == 0) return;
  Device& device = opened();
  cl::Event event;
  guarded("download of buffer '" + name_ + "'",
          [&] { device.queue().enqueueReadBuffer(buffer_, CL_TRUE, offset, bytes, target, nullptr, &event); });
  device.profiler().record("download " + name_, event, {bytes});
}

void BufferStorage::fill(const void* pattern, std::size_t patternBytes, std::size_t bytes) {
  if (bytes == 0) return;
  Device& device = opened();
  cl_event event = nullptr;
  // The C call, since the C++ one takes the pattern as a type.
  const cl_int code =
      clEnqueueFillBuffer(device.queue()(), buffer_(), pattern, patternBytes, 0, bytes, 0, nullptr, &event);
  if (code != CL_SUCCESS) throw deviceError(cl::Error(code, "clEnqueueFillBuffer"), "fill of buffer '" + name_ + "'");
  device.profiler().record("fill " + name_, cl::Event(event), {bytes});
}

void BufferStorage::checkRange(std::size_t offset, std::size_t count, std::size_t size) const {
  if (offset <= size && count <= size - offset) return;
  throw DeviceError("buffer '" + name_ + "': " + std::to_string(count) + " elements from " + std::to_string(offset) +
                    " asked for, but it has " + std::to_string(size));
}

Device& BufferStorage::opened() const {
  if (!device_) throw DeviceError("a buffer is used that was never allocated; construct it with a device first");
  return *device_;
}

}  // namespace cdsm::device
