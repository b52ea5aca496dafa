// SPDX-License-Identifier: Apache-2.0
// The spheres of all objects on the device, in object space. Moving objects does not touch them.
#pragma once

#include <memory>
#include <vector>

#include <cdsm/scene.hpp>

#include "build/geometry.hpp"
#include "device/buffer.hpp"
#include "shared/scene_data.h"

namespace cdsm::build {

class SphereBuffer {
 public:
  explicit SphereBuffer(device::Device& device) : device_(device) {}

  /// Uploads the spheres, in their order, unless they are what is there already. `firstObject`: number of the first
  /// set.
  void update(const std::vector<Spheres>& sets, std::size_t firstObject);

  const PrimitiveRange& rangeOf(std::size_t set) const { return ranges_[set]; }
  const device::Buffer<shared::SceneSphere>& spheres() const { return spheres_; }

 private:
  device::Device& device_;
  std::vector<std::shared_ptr<const SphereData>> data_;
  std::size_t firstObject_ = 0;
  std::vector<PrimitiveRange> ranges_;
  device::Buffer<shared::SceneSphere> spheres_;
};

}  // namespace cdsm::build
