// SPDX-License-Identifier: Apache-2.0
// Strategy "exact": one march and one reservation per tile, no node too many; lookup table of about 2 bytes per texel.
#pragma once

#include "memory/tile_strategy.hpp"

namespace cdsm::memory {

class Exact : public TileStrategy {
 public:
  Exact(device::Device& device, const NodeFormat& format, Mode mode = Mode::Fill);

  const char* kernelFile() const override { return "memory/exact.clh"; }
  MemoryStats stats() const override { return store_.stats("exact"); }

 private:
  void addMap(std::size_t index, shared::MapData& map, std::size_t stored,
              const shared::BuildCounters& counters) override;
  std::uint32_t moveRecord(std::uint32_t* record, std::uint32_t first) const override;

  device::Kernel<std::uint32_t, Uints, Uints, std::uint32_t> narrowTable_;
};

}  // namespace cdsm::memory
