// SPDX-License-Identifier: Apache-2.0
// Keeps count of the bytes that live on a device, since some implementations allocate lazily and fail far too late.
// In: the device's limits and each allocation; out: DeviceError with the number needed, before OpenCL is asked.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace cdsm::device {

/// The limits of one device and what is in use of them. Outlives the device as long as a claim does.
struct MemoryAccount {
  std::string device;                    ///< its name, for messages
  std::uint64_t maxAllocationBytes = 0;  ///< CL_DEVICE_MAX_MEM_ALLOC_SIZE
  std::uint64_t totalBytes = 0;          ///< CL_DEVICE_GLOBAL_MEM_SIZE
  std::atomic<std::uint64_t> usedBytes{0};
};

/// Bytes that one buffer or image holds; given back when it is destroyed. Move-only.
class MemoryClaim {
 public:
  MemoryClaim() = default;
  /// Throws DeviceError, naming `name`, the bytes and the limit, when a limit of the device would be passed.
  MemoryClaim(std::shared_ptr<MemoryAccount> account, std::uint64_t bytes, const std::string& name);
  ~MemoryClaim();
  MemoryClaim(MemoryClaim&& other) noexcept;
  MemoryClaim& operator=(MemoryClaim&& other) noexcept;

  std::uint64_t bytes() const { return bytes_; }

 private:
  std::shared_ptr<MemoryAccount> account_;
  std::uint64_t bytes_ = 0;
};

}  // namespace cdsm::device
