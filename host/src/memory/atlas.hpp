// SPDX-License-Identifier: Apache-2.0
// Strategy "atlas": a 3D grid with the same number of layers for every texel [Knecht 2011, §4.2.1].
#pragma once

#include "memory/memory_strategy.hpp"
#include "memory/node_texture.hpp"

namespace cdsm::memory {

/// Layers are added, and all maps built again, when a texel needs more than there are.
class Atlas : public MemoryStrategy {
 public:
  explicit Atlas(device::Device& device);

  const char* kernelFile() const override { return "memory/atlas.clh"; }
  void reserve(std::vector<shared::MapData>& maps) override;
  void beginMap() override;
  MapOutcome finishMap(std::size_t index, shared::MapData& map, std::string& why) override;
  void finish() override;
  shared::MemoryParams params() const override;
  device::ArgumentList writeArguments() const override;
  device::ArgumentList readArguments() const override;
  NodeCounts nodeCounts(std::size_t index) const override { return totals_[index]; }
  MemoryStats stats() const override;

 private:
  device::Device& device_;
  int layers_;
  shared::int4 size_{};  ///< texels along x and y, layers of one map, layers of all
  std::vector<NodeCounts> totals_;
  device::Buffer<shared::float2> nodes_;
  device::Buffer<std::uint32_t> counts_;
  device::Buffer<shared::BuildCounters> counters_;
  ReadablePool readable_;
};

}  // namespace cdsm::memory
