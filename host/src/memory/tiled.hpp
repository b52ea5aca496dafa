// SPDX-License-Identifier: Apache-2.0
// Strategy "tiled": blocks of a constant number of layers for tiles of texels, and a page table of low resolution
// [Hadwiger et al. 2006, in Knecht 2011, §2.3.4].
#pragma once

#include "memory/tile_strategy.hpp"

namespace cdsm::memory {

class Tiled : public TileStrategy {
 public:
  Tiled(device::Device& device, const NodeFormat& format, Mode mode = Mode::Fill);

  const char* kernelFile() const override { return "memory/tiled.clh"; }
  MemoryStats stats() const override { return store_.stats("tiled"); }

 private:
  void addMap(std::size_t index, shared::MapData& map, std::size_t stored,
              const shared::BuildCounters& counters) override;
  std::uint32_t moveRecord(std::uint32_t* record, std::uint32_t first) const override;
};

}  // namespace cdsm::memory
