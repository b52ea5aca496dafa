// SPDX-License-Identifier: Apache-2.0
// Typed device memory. In: a count of elements or host data; out: a cl::Buffer that gives its bytes back when
// destroyed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <CL/opencl.hpp>

#include "device/device.hpp"
#include "device/memory_account.hpp"

namespace cdsm::device {

/// "All that follows the offset" for Buffer::download().
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

/// Throws DeviceError unless memory that was given is of the device's context. `what` begins the message.
void requireContext(const Device& device, const cl::Memory& memory, const std::string& what);

/// The untyped part of Buffer: bytes, transfers and their errors. Offsets and sizes in bytes.
class BufferStorage {
 public:
  BufferStorage() = default;
  /// Throws DeviceError naming the buffer, count * elementBytes and the device's limit when it does not fit.
  BufferStorage(Device& device, std::size_t count, std::size_t elementBytes, std::string name);

  /// Memory of the host's, which must stay where it is.
  static BufferStorage inPlace(Device& device, void* memory, std::size_t bytes, bool written, std::string name);
  /// Somebody else's buffer, retained. Throws DeviceError unless it is a buffer of the device's context with `bytes`.
  static BufferStorage adopt(Device& device, cl_mem buffer, std::size_t bytes, std::string name);

  const cl::Buffer& cl() const { return buffer_; }
  const std::string& name() const { return name_; }
  Device* device() const { return device_; }

  void write(const void* source, std::size_t bytes, std::size_t offset);
  void read(void* target, std::size_t bytes, std::size_t offset) const;
  void fill(const void* pattern, std::size_t patternBytes, std::size_t bytes);
  /// In place: what kernels wrote is in the host's memory when it returns.
  void toHost(std::size_t bytes) const;
  /// Frees first, so that old and new need not fit together.
  void reallocate(std::size_t count, std::size_t elementBytes);
  /// Throws DeviceError unless offset + count <= size (all in elements).
  void checkRange(std::size_t offset, std::size_t count, std::size_t size) const;

 private:
  void allocate(std::size_t count, std::size_t elementBytes);
  Device& opened() const;

  Device* device_ = nullptr;
  std::string name_;
  MemoryClaim claim_;
  cl::Buffer buffer_;
};

/// `size()` elements of T on the device. Move-only; must not outlive its Device, though it may be destroyed after it.
/// Empty buffers hold one element underneath, so that kernels always get a valid one. Transfers block.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>, "the bytes of T travel to the device");

 public:
  using value_type = T;

  Buffer() = default;
  Buffer(Device& device, std::size_t count, std::string name)
      : storage_(device, count, sizeof(T), std::move(name)), size_(count) {}
  Buffer(Buffer&& other) noexcept : storage_(std::move(other.storage_)), size_(std::exchange(other.size_, 0)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    storage_ = std::move(other.storage_);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }

  static Buffer fromHost(Device& device, const T* values, std::size_t count, std::string name) {
    Buffer buffer(device, count, std::move(name));
    buffer.upload(values, count);
    return buffer;
  }
  static Buffer fromHost(Device& device, const std::vector<T>& values, std::string name) {
    return fromHost(device, values.data(), values.size(), std::move(name));
  }
  /// Whether kernels can use an array where it is.
  static bool canBeInPlace(const Device& device, const T* values, std::size_t count) {
    return count > 0 && device.sharesHostMemory() && reinterpret_cast<std::uintptr_t>(values) % alignof(T) == 0;
  }
  /// The array itself, which must stay until the buffer is gone; kernels only read it.
  static Buffer inPlace(Device& device, const T* values, std::size_t count, std::string name) {
    return {BufferStorage::inPlace(device, const_cast<T*>(values), count * sizeof(T), false, std::move(name)), count};
  }
  /// The same for kernels that write; then comes toHost().
  static Buffer inPlace(Device& device, T* values, std::size_t count, std::string name) {
    return {BufferStorage::inPlace(device, values, count * sizeof(T), true, std::move(name)), count};
  }
  /// Somebody else's buffer of at least `count` elements.
  static Buffer adopt(Device& device, cl_mem buffer, std::size_t count, std::string name) {
    return {BufferStorage::adopt(device, buffer, count * sizeof(T), std::move(name)), count};
  }

  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  /// False for a default-constructed buffer, which no kernel may be given.
  bool allocated() const { return storage_.cl()() != nullptr; }
  const cl::Buffer& cl() const { return storage_.cl(); }
  const std::string& name() const { return storage_.name(); }

  /// Writes `count` elements from element `offset` on; throws DeviceError past the end.
  void upload(const T* values, std::size_t count, std::size_t offset = 0) {
    storage_.checkRange(offset, count, size_);
    storage_.write(values, count * sizeof(T), offset * sizeof(T));
  }
  void upload(const std::vector<T>& values) { upload(values.data(), values.size()); }

  /// Waits for what was enqueued before; throws DeviceError past the end.
  std::vector<T> download(std::size_t count = kAll, std::size_t offset = 0) const {
    if (count == kAll) count = offset <= size_ ? size_ - offset : 0;
    storage_.checkRange(offset, count, size_);
    std::vector<T> values(count);
    storage_.read(values.data(), count * sizeof(T), offset * sizeof(T));
    return values;
  }
  void download(T* values) const { storage_.read(values, bytes(), 0); }
  void toHost() const { storage_.toHost(bytes()); }
  T read(std::size_t index) const {
    storage_.checkRange(index, 1, size_);
    T value;
    storage_.read(&value, sizeof(T), index * sizeof(T));
    return value;
  }

  /// Every element becomes `value`. OpenCL knows patterns of 1, 2, 4 ... 128 bytes.
  void fill(const T& value) {
    static_assert(sizeof(T) <= 128 && (sizeof(T) & (sizeof(T) - 1)) == 0, "no fill pattern of this size in OpenCL");
    storage_.fill(&value, sizeof(T), bytes());
  }

  /// Room for at least `count` elements: size() becomes `count` and the content is lost if it had fewer.
  /// True if it grew. After a reserve() that threw the buffer is not allocated; the next one that fits makes it usable.
  bool reserve(std::size_t count) {
    if (count <= size_ && allocated()) return false;
    size_ = 0;
    storage_.reallocate(count, sizeof(T));
    size_ = count;
    return true;
  }

 private:
  Buffer(BufferStorage storage, std::size_t count) : storage_(std::move(storage)), size_(count) {}

  BufferStorage storage_;
  std::size_t size_ = 0;
};

}  // namespace cdsm::device
