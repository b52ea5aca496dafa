// SPDX-License-Identifier: Apache-2.0
#include "memory/node_pool.hpp"

namespace cdsm::memory {

namespace {

constexpr std::size_t kTexelsPerRow = std::size_t(1) << CDSM_NODE_TEXTURE_BITS;
constexpr std::size_t kNodesPerRow = 2 * kTexelsPerRow;

}  // namespace

std::size_t poolSize(const device::Device& device, std::size_t count) {
  if (!device.fetchImages()) return count;
  return std::max<std::size_t>(1, (count + kNodesPerRow - 1) / kNodesPerRow) * kNodesPerRow;
}

std::size_t poolSizeOfRuns(const device::Device& device, std::size_t count) {
  return poolSize(device, count + kGuardNodes);
}

void ReadablePool::finish(device::Device& device, const NodeBuffer& pool) {
  if (!device.fetchImages()) {
    argument_ = pool.cl();
    return;
  }
  const std::size_t rows = pool.size() / kNodesPerRow;
  if (texture_.height() != rows) {
    texture_ = {};
    texture_ = device::NodeTexture(device, kTexelsPerRow, rows, "nodes");
  }
  texture_.fill(pool.cl());
  argument_ = texture_.image();
}

}  // namespace cdsm::memory
