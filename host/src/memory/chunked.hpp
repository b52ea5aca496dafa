// SPDX-License-Identifier: Apache-2.0
// Strategy "chunked": linked chunks while building, each texel's nodes side by side afterwards [Knecht 2011, §4.2.2].
#pragma once

#include "device/scan.hpp"
#include "memory/map_store.hpp"

namespace cdsm::memory {

/// Chunks are scratch memory of one map at a time; the finished maps hold exactly their nodes and the lookup table.
class Chunked : public MemoryStrategy {
 public:
  Chunked(device::Device& device, const NodeFormat& format);

  const char* kernelFile() const override { return "memory/chunked.clh"; }
  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) override;
  void beginMap() override;
  bool finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) override;
  void finish() override;
  shared::MemoryParams params() const override;
  device::ArgumentList writeArguments() const override;
  device::ArgumentList readArguments() const override;
  NodeCounts nodeCounts(std::size_t index) const override { return store_.nodeCounts(index); }
  MemoryStats stats() const override;

 private:
  using Uints = device::Buffer<std::uint32_t>;
  using Floats = device::Buffer<float>;

  void reserveChunks(std::size_t chunks);

  device::Device& device_;
  device::Scan scan_;
  MapStore store_;  ///< its table says where the nodes of each texel start: texels + 1 entries for each map
  std::size_t chunkRoom_ = 1024;  ///< that was enough before: so that an animation does not grow it in every frame
  std::uint64_t chunksUsed_ = 0;

  Floats chunkDepths_, chunkValues_;
  Uints chunkNext_, firstChunks_, nodeCounts_, mapStarts_;
  device::Buffer<shared::BuildCounters> counters_;
  device::Kernel<std::uint32_t, std::uint32_t, Uints, Uints, Uints, Floats, Floats, NodeBuffer> gatherNodes_;
};

}  // namespace cdsm::memory
