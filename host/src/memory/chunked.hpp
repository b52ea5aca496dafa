// SPDX-License-Identifier: Apache-2.0
// Strategy "chunked": linked chunks while building, each texel's nodes side by side afterwards [Knecht 2011, §4.2.2].
#pragma once

#include "device/scan.hpp"
#include "memory/memory_strategy.hpp"
#include "memory/node_texture.hpp"

namespace cdsm::memory {

/// Chunks are scratch memory of one map at a time; the finished maps hold exactly their nodes and the lookup table.
class Chunked : public MemoryStrategy {
 public:
  explicit Chunked(device::Device& device);

  const char* kernelFile() const override { return "memory/chunked.clh"; }
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
  using Uints = device::Buffer<std::uint32_t>;
  using Floats = device::Buffer<float>;
  using Nodes = device::Buffer<shared::float2>;

  /// Where a map's part of the lookup table and its nodes are.
  struct Place {
    std::size_t texels = 0, firstTexel = 0, firstNode = 0;
    NodeCounts nodes;
  };

  void reserveChunks(std::size_t chunks);
  /// Moves the nodes and table entries of kept maps to their new places, side by side.
  void takeOver(const std::vector<Place>& before, std::vector<shared::MapData>& maps, const std::vector<int>& kept,
                std::size_t entries);
  /// Room for `nodes` in the pool; keeps the first `kept`.
  void growPool(std::size_t nodes, std::size_t kept);

  device::Device& device_;
  device::Scan scan_;
  std::vector<Place> placed_;
  std::size_t usedNodes_ = 0;
  std::size_t chunkRoom_ = 1024;  ///< that was enough before: so that an animation does not grow it in every frame
  std::uint64_t chunksUsed_ = 0;

  Floats chunkDepths_, chunkValues_;
  Uints chunkNext_, firstChunks_, nodeCounts_, mapStarts_;
  device::Buffer<shared::BuildCounters> counters_;
  Uints starts_;  ///< the lookup table of all maps: texels + 1 entries for each
  Nodes pool_;
  ReadablePool readable_;
  device::Kernel<std::uint32_t, std::uint32_t, Uints, Uints, Uints, Floats, Floats, Nodes> gatherNodes_;
};

}  // namespace cdsm::memory
