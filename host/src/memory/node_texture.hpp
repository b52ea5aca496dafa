// SPDX-License-Identifier: Apache-2.0
// The finished pool of nodes as kernel argument: the buffer itself, or on image devices a texture made of it.
#pragma once

#include "device/buffer.hpp"
#include "device/texture.hpp"
#include "shared/map_data.h"

namespace cdsm::memory {

/// Nodes that a pool for `count` must have room for: whole rows of the texture on image devices.
std::size_t poolSize(const device::Device& device, std::size_t count);

/// What kernels read nodes from; `pool` has poolSize() of nodes.
class ReadablePool {
 public:
  void finish(device::Device& device, const device::Buffer<shared::float2>& pool);
  cl::Memory argument() const { return argument_; }

 private:
  device::NodeTexture texture_;
  cl::Memory argument_;
};

}  // namespace cdsm::memory
