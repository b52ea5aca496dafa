// SPDX-License-Identifier: Apache-2.0
// Strategy "fixed": the same number of nodes for every texel; what does not fit is merged, and how far functions moved
// by that is reported.
#pragma once

#include "memory/map_store.hpp"

namespace cdsm::memory {

class Fixed : public MemoryStrategy {
 public:
  /// `nodesPerTexel`: at least 2.
  Fixed(device::Device& device, const NodeFormat& format, int nodesPerTexel);

  const char* kernelFile() const override { return "memory/fixed.clh"; }
  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) override;
  void beginMap() override;
  bool finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) override;
  void finish() override;
  shared::MemoryParams params() const override;
  device::ArgumentList writeArguments() const override;
  device::ArgumentList readArguments() const override { return {store_.readable()}; }
  NodeCounts nodeCounts(std::size_t index) const override { return store_.nodeCounts(index); }
  MemoryStats stats() const override;

 private:
  device::Device& device_;
  MapStore store_;  ///< without a table
  std::size_t nodesPerTexel_;
  std::size_t texels_ = 0;             ///< of the largest map
  std::vector<float> mergeErrors_;     ///< per map
  device::Buffer<float> pieceErrors_;  ///< of the map being built, as the next two
  device::Buffer<std::uint32_t> nodeCounts_;
  device::Buffer<float> texelErrors_;
};

}  // namespace cdsm::memory
