// SPDX-License-Identifier: Apache-2.0
#include "memory/node_pool.hpp"

#include "shared/map_data.h"

namespace cdsm::memory {

namespace {

constexpr std::size_t kPixelsPerRow = std::size_t(1) << CDSM_NODE_TEXTURE_BITS;

std::size_t nodesPerRow(const NodeFormat& format) { return format.pixelNodes() * kPixelsPerRow; }

}  // namespace

std::size_t poolSize(const device::Device& device, const NodeFormat& format, std::size_t count) {
  if (!device.fetchImages()) return count;
  const std::size_t row = nodesPerRow(format);
  return std::max<std::size_t>(1, (count + row - 1) / row) * row;
}

std::size_t poolSizeOfRuns(const device::Device& device, const NodeFormat& format, std::size_t count) {
  return poolSize(device, format, count + kGuardNodes);
}

void ReadablePool::finish(device::Device& device, const NodeFormat& format, const NodeBuffer& pool) {
  if (!device.fetchImages()) {
    argument_ = pool.cl();
    return;
  }
  const std::size_t rows = pool.bytes() / (format.bytes() * nodesPerRow(format));
  if (texture_.height() != rows) {
    texture_ = {};
    texture_ = device::NodeTexture(device, kPixelsPerRow, rows, "nodes", format.pixelType);
  }
  texture_.fill(pool.cl());
  argument_ = texture_.image();
}

}  // namespace cdsm::memory
