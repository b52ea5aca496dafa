// SPDX-License-Identifier: Apache-2.0
// Technique "deep-shadow-map": one compressed visibility function per texel of each light's maps [Knecht 2011, §3.2].
#pragma once

#include <memory>

#include "technique/map_technique.hpp"

namespace cdsm::technique {

class DeepShadowMap : public MapTechnique {
 public:
  DeepShadowMap(device::Device& device, std::unique_ptr<memory::MemoryStrategy> memory);

  build::Defines kernelFiles() const override;
  shared::TechniqueParams params(const Scene& scene) const override;
  device::ArgumentList arguments() const override;

 private:
  std::vector<shared::MapData> buildMaps(const Preparation& to, const std::vector<build::MapJob>& jobs) override;
  memory::NodeCounts nodeCounts(std::size_t map) const override { return memory_->nodeCounts(map); }
  MemoryStats memoryStats() const override { return memory_->stats(); }

  std::unique_ptr<memory::MemoryStrategy> memory_;
  build::MapPass pass_;
};

}  // namespace cdsm::technique
