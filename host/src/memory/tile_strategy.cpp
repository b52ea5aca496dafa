// SPDX-License-Identifier: Apache-2.0
#include "memory/tile_strategy.hpp"

#include <algorithm>

#include "shared/view_data.h"

namespace cdsm::memory {

namespace {

/// Enough for most scenes at tolerance 0.01.
constexpr std::size_t kFirstTileRoom = 8 * CDSM_TILE_PIXELS;

std::uint64_t wide(shared::uint low, shared::uint high) { return std::uint64_t(high) << 32 | low; }

}  // namespace

int tileChunks(const device::Device& device, const Spectrum& spectrum) {
  const std::size_t nodeBytes = (1 + spectrum.channels) * sizeof(float);
  const std::size_t chunkBytes =
      CDSM_CHUNK_NODES * nodeBytes + sizeof(std::uint32_t);  // and the number of the next one
  // a quarter, so that several groups are in flight; more than 1024 (128 nodes per texel) hardly any tile needs
  const std::size_t bytes = std::size_t(device.description().localMemoryBytes) / 4;
  return int(std::clamp<std::size_t>(bytes / chunkBytes, 128, 1024));
}

TileStrategy::TileStrategy(device::Device& device, const NodeFormat& format, std::size_t recordWords, Mode mode)
    : MemoryStrategy(device, format),
      device_(device),
      store_(device, format),
      recordWords_(recordWords),
      mode_(mode),
      counters_(device, 1, "build counters") {}

void TileStrategy::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  store_.reserve(maps, kept);
  mostTiles_ = 0;
  for (const shared::MapData& map : maps) mostTiles_ = std::max(mostTiles_, tilesOf(map));
  records_ = Uints(device_, mostTiles_ * recordWords_, "places of tiles");
  unfilled_ = Uints(device_, mostTiles_, "tiles without nodes");
  fill_ = false;
}

void TileStrategy::beginMap() {
  if (fill_) return;
  counters_.fill({});
  if (mode_ == Mode::Count) return;
  // at first a part of what the device allows, so that a map that is almost empty is not refused for it
  const std::size_t most = std::size_t(device_.maxAllocationBytes()) / 4 / format().bytes();
  store_.makeRoom(std::max(tileRoom_ * mostTiles_, std::min(kFirstTileRoom * mostTiles_, most)));
}

bool TileStrategy::finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) {
  const shared::BuildCounters counters = counters_.read(0);
  const std::uint64_t room = wide(counters.roomLow, counters.roomHigh);
  if (!fill_ && counters.unfilledTiles > 0) {
    why = std::to_string(counters.unfilledTiles) + " tiles of 8 x 8 texels have more nodes than there was room for; " +
          "room made, these tiles built again";
    const std::size_t had = store_.room();
    store_.makeRoom(room, std::min<std::uint64_t>(room, had));
    if (mode_ == Mode::Count) placeInOrder(tilesOf(maps[index]));
    fill_ = true;
    return false;
  }
  fill_ = false;
  tileRoom_ = std::max<std::size_t>(tileRoom_, (room + room / 8) / tilesOf(maps[index]));
  addMap(index, maps[index], room, counters);
  return true;
}

void TileStrategy::placeInOrder(std::size_t tiles) {
  std::vector<std::uint32_t> records = records_.download(tiles * recordWords_);
  std::uint32_t next = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile) next += moveRecord(&records[tile * recordWords_], next);
  records_.upload(records.data(), records.size());
}

void TileStrategy::finish() {
  store_.finish();
  records_ = {};
  unfilled_ = {};
}

shared::MemoryParams TileStrategy::params() const {
  shared::MemoryParams params{};
  params.firstNode = shared::uint(store_.nextNode());
  params.capacity = shared::uint(store_.room());
  params.scratchChunks = mode_ == Mode::Fill ? shared::uint(tileChunks(device_, spectrumNamed(format().spectrum))) : 0;
  params.fill = fill_;
  return params;
}

device::ArgumentList TileStrategy::writeArguments() const {
  return {store_.nodes().cl(), records_.cl(), unfilled_.cl(), counters_.cl()};
}

device::ArgumentList TileStrategy::readArguments() const { return {store_.table().cl(), store_.readable()}; }

}  // namespace cdsm::memory
