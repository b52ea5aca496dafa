// SPDX-License-Identifier: Apache-2.0
// The scales of the depths of all tiles of all maps, for formats of nodes that have them (kernels/memory/node_*.clh).
#pragma once

#include <vector>

#include "device/kernel.hpp"
#include "memory/node_format.hpp"
#include "memory/run_buffer.hpp"
#include "shared/map_data.h"

namespace cdsm::memory {

/// In place of the number of a map that is taken over.
constexpr int kBuildAnew = -1;

/// Tiles of 8 x 8 texels that a map has.
std::size_t tilesOf(const shared::MapData& map);

class TileDepths {
 public:
  TileDepths(device::Device& device, const NodeFormat& format);

  /// Room for the tiles of these maps, those of the kept ones (as MemoryStrategy::reserve) taken over; says in each
  /// where its tiles are.
  void reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept);
  /// The argument of kernels that build or read maps; none if the format needs none.
  device::ArgumentList arguments() const;
  /// The scales of a map's tiles.
  std::vector<shared::float2> download(const shared::MapData& map) const {
    return scales_.buffer().download(tilesOf(map), map.firstTile);
  }
  std::size_t bytes() const { return wanted_ ? scales_.bytes() : 0; }

 private:
  bool wanted_;
  std::vector<Run> placed_;  ///< per map
  RunBuffer<shared::float2> scales_;
};

}  // namespace cdsm::memory
