// SPDX-License-Identifier: Apache-2.0
// The nodes of all maps: how one is stored (kernels/memory/node_format.clh), the pool of them, and what kernels read it
// from: the buffer itself, or on image devices a texture made of it.
#pragma once

#include "device/buffer.hpp"
#include "device/texture.hpp"
#include "shared/map_data.h"

namespace cdsm::memory {

using StoredNode = shared::float2;
using NodeBuffer = device::Buffer<StoredNode>;

constexpr std::size_t kGuardNodes = 1;

/// Nodes that a pool for `count` must have room for: whole rows of the texture on image devices.
std::size_t poolSize(const device::Device& device, std::size_t count);

/// The same with kGuardNodes more: a texel without nodes reads the one at its place, and ignores it.
std::size_t poolSizeOfRuns(const device::Device& device, std::size_t count);

/// What kernels read nodes from; `pool` has poolSize() of nodes.
class ReadablePool {
 public:
  void finish(device::Device& device, const NodeBuffer& pool);
  cl::Memory argument() const { return argument_; }

 private:
  device::NodeTexture texture_;
  cl::Memory argument_;
};

}  // namespace cdsm::memory
