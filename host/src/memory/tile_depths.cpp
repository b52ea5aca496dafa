// SPDX-License-Identifier: Apache-2.0
#include "memory/tile_depths.hpp"

#include <utility>

#include "shared/view_data.h"

namespace cdsm::memory {

std::size_t tilesOf(const shared::MapData& map) {
  const auto across = [](int texels) { return std::size_t(texels + CDSM_TILE - 1) / CDSM_TILE; };
  return across(map.width) * across(map.height);
}

TileDepths::TileDepths(device::Device& device, const NodeFormat& format)
    : wanted_(format.tileDepths), scales_(device, "depths of tiles") {}

void TileDepths::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  if (!wanted_) return;
  const std::vector<Run> before = std::exchange(placed_, std::vector<Run>(maps.size()));
  std::vector<Run*> runs;
  std::size_t tiles = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (kept[i] == kBuildAnew) {
      tiles += tilesOf(maps[i]);
    } else {
      placed_[i] = before[kept[i]];
      runs.push_back(&placed_[i]);
    }
  }
  scales_.keep(runs, tiles);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (kept[i] == kBuildAnew) placed_[i] = scales_.append(tilesOf(maps[i]));
    maps[i].firstTile = shared::uint(placed_[i].first);
  }
}

device::ArgumentList TileDepths::arguments() const {
  if (!wanted_) return {};
  return {scales_.buffer().cl()};
}

}  // namespace cdsm::memory
