// SPDX-License-Identifier: Apache-2.0
// The spheres of all objects on the device, in object space. Moving objects does not touch them.
#pragma once

#include <cstdint>
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

  /// Uploads the spheres, in their order. If as many come in the same places as before, only the sets that have
  /// changed. `firstObject`: number of the first set.
  void update(const std::vector<Spheres>& sets, std::size_t firstObject);

  const PrimitiveRange& rangeOf(std::size_t set) const { return ranges_[set]; }
  const device::Buffer<shared::SceneSphere>& spheres() const { return spheres_; }

 private:
  /// What a range holds.
  struct Held {
    std::shared_ptr<const SphereData> data;
    std::uint64_t revision = 0;
    std::size_t object = 0;

    bool operator==(const Held& other) const {
      return data == other.data && revision == other.revision && object == other.object;
    }
  };

  bool fit(const std::vector<Held>& sets) const;
  void makeRoom(const std::vector<Held>& sets);
  void upload(std::size_t set, const Held& spheres);

  device::Device& device_;
  std::vector<Held> held_;
  std::vector<PrimitiveRange> ranges_;
  device::Buffer<shared::SceneSphere> spheres_;
};

}  // namespace cdsm::build
