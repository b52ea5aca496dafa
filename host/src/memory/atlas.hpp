// SPDX-License-Identifier: Apache-2.0
// Strategy "atlas": a 3D grid with the same number of layers for every texel [Knecht 2011, §4.2.1].
#pragma once

#include "memory/memory_strategy.hpp"
#include "memory/node_pool.hpp"

namespace cdsm::memory {

/// Layers are added when a texel needs more than there are: then the maps move to a taller grid.
class Atlas : public MemoryStrategy {
 public:
  Atlas(device::Device& device, const NodeFormat& format);

  const char* kernelFile() const override { return "memory/atlas.clh"; }
  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) override;
  void beginMap() override;
  bool finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) override;
  void finish() override;
  shared::MemoryParams params() const override;
  device::ArgumentList writeArguments() const override;
  device::ArgumentList readArguments() const override;
  NodeCounts nodeCounts(std::size_t index) const override { return placed_[index].nodes; }
  MemoryStats stats() const override;

 private:
  struct Place {
    shared::int4 offset{};  ///< MapData::atlasOffset
    bool filled = false;
    NodeCounts nodes;
  };

  /// Places for maps of `side` texels a side, in a grid of `layers_` layers each.
  void arrange(std::vector<shared::MapData>& maps);
  /// Gives the places of `placed_` a grid, and takes over what `from` says: number in `before`, or kBuildAnew.
  void moveNodes(const std::vector<Place>& before, const std::vector<int>& from, const shared::int4& sizeBefore);

  device::Device& device_;
  int layers_;
  int side_ = 1;         ///< texels of each map
  shared::int4 size_{};  ///< texels along x and y, layers of one map, layers of all
  std::vector<Place> placed_;
  NodeBuffer nodes_;
  device::Buffer<std::uint32_t> counts_;
  device::Buffer<shared::BuildCounters> counters_;
  ReadablePool readable_;
};

}  // namespace cdsm::memory
