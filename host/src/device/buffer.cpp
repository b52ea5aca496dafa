// SPDX-License-Identifier: Apache-2.0
// Untyped device memory. In: counts and host bytes; out: checked allocations and profiled transfers.
#include "device/buffer.hpp"

#include "device/cl_error.hpp"

namespace cdsm::device {

void requireContext(const Device& device, const cl::Memory& memory, const std::string& what) {
  if (memory.getInfo<CL_MEM_CONTEXT>()() != device.context()())
    throw DeviceError(what + " is of another context, must be of the engine's (opencl::placeOf)");
}

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

BufferStorage BufferStorage::inPlace(Device& device, void* memory, std::size_t bytes, bool written, std::string name) {
  BufferStorage storage;
  storage.device_ = &device;
  storage.name_ = std::move(name);
  storage.claim_ = MemoryClaim(device.account(), bytes, "buffer '" + storage.name_ + "'");
  const cl_mem_flags access = written ? CL_MEM_READ_WRITE : CL_MEM_READ_ONLY;
  storage.buffer_ = guarded("buffer '" + storage.name_ + "' in the host's memory",
                            [&] { return cl::Buffer(device.context(), access | CL_MEM_USE_HOST_PTR, bytes, memory); });
  return storage;
}

BufferStorage BufferStorage::adopt(Device& device, cl_mem buffer, std::size_t bytes, std::string name) {
  if (!buffer) throw DeviceError("the buffer given as '" + name + "' is null");
  BufferStorage storage;
  storage.device_ = &device;
  storage.name_ = std::move(name);
  guarded("the buffer given as '" + storage.name_ + "'", [&] {
    storage.buffer_ = cl::Buffer(buffer, true);
    const std::string what = "the memory given as '" + storage.name_ + "'";
    if (storage.buffer_.getInfo<CL_MEM_TYPE>() != CL_MEM_OBJECT_BUFFER)
      throw DeviceError(what + " is an image, must be a buffer");
    requireContext(device, storage.buffer_, what);
    const std::size_t has = storage.buffer_.getInfo<CL_MEM_SIZE>();
    if (has < bytes)
      throw DeviceError(what + " has " + std::to_string(has) + " bytes, must have at least " + std::to_string(bytes));
  });
  return storage;
}

void BufferStorage::toHost(std::size_t bytes) const {
  if (bytes == 0) return;
  Device& device = opened();
  cl::Event event;
  guarded("reading buffer '" + name_ + "' in place", [&] {
    void* mapped = device.queue().enqueueMapBuffer(buffer_, CL_TRUE, CL_MAP_READ, 0, bytes, nullptr, &event);
    device.queue().enqueueUnmapMemObject(buffer_, mapped);
  });
  device.profiler().record("map " + name_, event);
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
