// SPDX-License-Identifier: Apache-2.0
// Strategy "counted", the example of docs/memory-strategies.md: count, prefix sum, fill.
#pragma once

#include "device/scan.hpp"
#include "memory/map_store.hpp"

namespace cdsm::strategies {

class Counted : public memory::MemoryStrategy {
 public:
  Counted(device::Device& device, const memory::NodeFormat& format)
      : MemoryStrategy(device, format), device_(device), scan_(device), store_(device, format) {}

  const char* kernelFile() const override { return CDSM_TEST_DATA "/../strategies/counted.clh"; }
  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) override;
  void beginMap() override {}
  bool finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) override;
  void finish() override { store_.finish(); }
  shared::MemoryParams params() const override;
  device::ArgumentList writeArguments() const override;
  device::ArgumentList readArguments() const override { return {store_.table().cl(), store_.readable()}; }
  memory::NodeCounts nodeCounts(std::size_t index) const override { return store_.nodeCounts(index); }
  MemoryStats stats() const override { return store_.stats("counted"); }

 private:
  device::Device& device_;
  device::Scan scan_;
  memory::MapStore store_;
  bool fill_ = false;
  std::uint32_t nodes_ = 0;
  device::Buffer<std::uint32_t> counts_, starts_;  ///< of the map being built
};

}  // namespace cdsm::strategies
