// SPDX-License-Identifier: Apache-2.0
// The nodes of all maps: the pool of them, and what kernels read it from: the buffer itself, or on image devices a
// texture made of it.
#pragma once

#include "device/buffer.hpp"
#include "memory/node_format.hpp"

namespace cdsm::memory {

/// NodeFormat::words for each node.
using NodeBuffer = device::Buffer<std::uint32_t>;

constexpr std::size_t kGuardNodes = 1;

/// Nodes that a pool for `count` must have room for: whole rows of the texture on image devices.
std::size_t poolSize(const device::Device& device, const NodeFormat& format, std::size_t count);

/// The same with kGuardNodes more: a texel without nodes reads the one at its place, and ignores it.
std::size_t poolSizeOfRuns(const device::Device& device, const NodeFormat& format, std::size_t count);

/// What kernels read nodes from; `pool` has poolSize() of nodes.
class ReadablePool {
 public:
  void finish(device::Device& device, const NodeFormat& format, const NodeBuffer& pool);
  cl::Memory argument() const { return argument_; }

 private:
  device::NodeTexture texture_;
  cl::Memory argument_;
};

}  // namespace cdsm::memory
