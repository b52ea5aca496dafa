// SPDX-License-Identifier: Apache-2.0
#include "memory/tiled.hpp"

#include "device/copy.hpp"
#include "shared/view_data.h"

namespace cdsm::memory {

namespace {

constexpr std::size_t kPageWords = 2;  ///< place of the first block, layers

}  // namespace

Tiled::Tiled(device::Device& device, const NodeFormat& format, Mode mode)
    : TileStrategy(device, format, kPageWords, mode) {}

void Tiled::addMap(std::size_t index, shared::MapData& map, std::size_t stored, const shared::BuildCounters& counters) {
  const std::size_t words = tilesOf(map) * kPageWords;
  const std::uint64_t nodes = std::uint64_t(counters.nodesHigh) << 32 | counters.nodesLow;
  store_.add(index, map, stored, {nodes, counters.maxNodes}, words);
  device::copyElements(device_, records_, 0, words, store_.table(), map.firstTexel);
}

std::uint32_t Tiled::moveRecord(std::uint32_t* record, std::uint32_t first) const {
  record[0] = first;
  return record[1] * CDSM_TILE_PIXELS;
}

}  // namespace cdsm::memory
