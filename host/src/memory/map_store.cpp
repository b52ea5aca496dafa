// SPDX-License-Identifier: Apache-2.0
#include "memory/map_store.hpp"

#include <utility>

namespace cdsm::memory {

MapStore::MapStore(device::Device& device, const NodeFormat& format)
    : device_(device),
      format_(format),
      pool_(device, "pool of nodes", format.words,
            [&](std::size_t nodes) { return poolSizeOfRuns(device, format, nodes); }),
      table_(device, "lookup table") {}

void MapStore::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  const std::vector<Place> before = std::exchange(placed_, std::vector<Place>(maps.size()));
  std::vector<Run*> nodes, words;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (kept[i] == kBuildAnew) continue;
    placed_[i] = before[kept[i]];
    nodes.push_back(&placed_[i].nodes);
    words.push_back(&placed_[i].words);
  }
  pool_.keep(nodes);
  table_.keep(words);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].firstNode = shared::uint(placed_[i].nodes.first);
    maps[i].firstTexel = shared::uint(placed_[i].words.first);
  }
}

void MapStore::add(std::size_t index, shared::MapData& map, std::size_t stored, const NodeCounts& counts,
                   std::size_t words) {
  table_.makeRoom(words);
  placed_[index] = {pool_.append(stored), table_.append(words), counts};
  map.firstNode = shared::uint(placed_[index].nodes.first);
  map.firstTexel = shared::uint(placed_[index].words.first);
}

void MapStore::finish() {
  pool_.trim();
  table_.trim();
  readable_.finish(device_, format_, pool_.buffer());
}

MemoryStats MapStore::stats(const char* strategy) const {
  std::size_t nodes = 0;
  for (const Place& map : placed_) nodes += map.counts.total;
  MemoryStats stats;
  stats.strategy = strategy;
  stats.bytesReserved = pool_.bytes() + table_.bytes();
  stats.bytesUsed = (nodes + kGuardNodes) * format_.bytes() + table_.bytesUsed();
  stats.bytesWasted = stats.bytesReserved - stats.bytesUsed;
  stats.bytesPerNode = double(format_.bytes());
  return stats;
}

}  // namespace cdsm::memory
