// SPDX-License-Identifier: Apache-2.0
// Exclusive prefix sums on the device (build/scan.cl).
#pragma once

#include <cstdint>

#include "device/buffer.hpp"
#include "device/device.hpp"
#include "device/kernel.hpp"

namespace cdsm::device {

/// Reusable; keeps its scratch memory.
class Scan {
 public:
  explicit Scan(Device& device);

  /// sums[i] = values[0] + ... + values[i - 1] for i = 0 .. count; returns sums[count]. `sums` holds count + 1.
  /// Throws DeviceError with the total if it is not below 2^32.
  std::uint32_t operator()(std::size_t count, const Buffer<std::uint32_t>& values, Buffer<std::uint32_t>& sums);

 private:
  using Uints = Buffer<std::uint32_t>;
  using Sums = Buffer<std::uint64_t>;
  Device& device_;
  Sums blockSums_;
  Kernel<std::uint32_t, Uints, Sums> scanBlockSums_;
  Kernel<std::uint32_t, Sums> scanBlocks_;
  Kernel<std::uint32_t, Uints, Sums, Uints> scanValues_;
};

}  // namespace cdsm::device
