// SPDX-License-Identifier: Apache-2.0
#include "memory/chunked.hpp"

#include <algorithm>
#include <utility>

#include "device/copy.hpp"
#include "device/program.hpp"

namespace cdsm::memory {

Chunked::Chunked(device::Device& device)
    : device_(device),
      scan_(device),
      counters_(device, 1, "build counters"),
      pool_(device, 0, "pool of nodes"),
      gatherNodes_(device, device.programs().get({"memory/gather_nodes.cl", {}, {}}), "gatherNodes") {}

void Chunked::reserveChunks(std::size_t chunks) {
  if (chunks <= chunkNext_.size()) return;
  if (chunks > 0xffffffffu / CDSM_CHUNK_NODES)
    throw DeviceError("a map needs " + std::to_string(chunks) +
                      " chunks, more than 2^29; take smaller maps or a larger tolerance");
  chunkDepths_ = {};
  chunkValues_ = {};
  chunkNext_ = {};
  chunkRoom_ = chunks;
  chunkDepths_ = Floats(device_, chunks * CDSM_CHUNK_NODES, "depths of chunks");
  chunkValues_ = Floats(device_, chunks * CDSM_CHUNK_NODES, "transmittances of chunks");
  chunkNext_ = Uints(device_, chunks, "links of chunks");
}

void Chunked::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  const std::vector<Place> before = std::exchange(placed_, std::vector<Place>(maps.size()));
  std::size_t entries = 0, texels = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    placed_[i].texels = std::size_t(maps[i].width) * maps[i].height;
    placed_[i].firstTexel = entries;
    maps[i].firstTexel = shared::uint(entries);
    texels = std::max(texels, placed_[i].texels);
    entries += placed_[i].texels + 1;
  }
  if (entries > 0xffffffffu)
    throw DeviceError("the lookup table needs " + std::to_string(entries) +
                      " entries, more than 2^32; take smaller maps or fewer lights");
  takeOver(before, maps, kept, entries);
  firstChunks_ = Uints(device_, texels, "first chunks of texels");
  nodeCounts_ = Uints(device_, texels, "nodes per texel");
  mapStarts_ = Uints(device_, texels + 1, "starts of texels");
  reserveChunks(std::max(texels, chunkRoom_));
  chunksUsed_ = 0;
}

void Chunked::takeOver(const std::vector<Place>& before, std::vector<shared::MapData>& maps,
                       const std::vector<int>& kept, std::size_t entries) {
  usedNodes_ = 0;
  for (const int old : kept) usedNodes_ += old == kBuildAnew ? 0 : before[old].nodes.total;
  if (usedNodes_ == 0) starts_ = {};
  Uints starts(device_, entries, "lookup table");
  Nodes pool(device_, poolSize(device_, usedNodes_ + 1), "pool of nodes");
  std::size_t next = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (kept[i] == kBuildAnew) continue;
    const Place& old = before[kept[i]];
    placed_[i].nodes = old.nodes;
    placed_[i].firstNode = next;
    maps[i].firstNode = shared::uint(next);
    device::copyElements(device_, starts_, old.firstTexel, old.texels + 1, starts, placed_[i].firstTexel);
    device::copyElements(device_, pool_, old.firstNode, old.nodes.total, pool, next);
    next += old.nodes.total;
  }
  starts_ = std::move(starts);
  pool_ = std::move(pool);
}

void Chunked::beginMap() { counters_.fill({}); }

void Chunked::growPool(std::size_t nodes, std::size_t kept) {
  ++nodes;  // one more: a texel without nodes reads the one behind its place, and ignores it
  if (poolSize(device_, nodes) <= pool_.size()) return;
  if (nodes > 0xffffffffu)
    throw DeviceError("the maps need " + std::to_string(nodes) +
                      " nodes, more than 2^32; take smaller maps or a larger tolerance");
  Nodes larger(device_, poolSize(device_, nodes), "pool of nodes");
  device::copyElements(device_, pool_, 0, kept, larger, 0);
  pool_ = std::move(larger);
}

bool Chunked::finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) {
  const shared::BuildCounters counters = counters_.read(0);
  const std::size_t chunks = counters.chunks, room = chunkNext_.size();
  if (chunks > room) {
    why = "room for chunks grown from " + std::to_string(room) + " to " + std::to_string(chunks) + "; map built again";
    reserveChunks(chunks);
    return false;
  }
  Place& place = placed_[index];
  const std::size_t texels = place.texels;
  const std::size_t nodes = scan_(texels, nodeCounts_, mapStarts_);
  growPool(usedNodes_ + nodes, usedNodes_);
  place.firstNode = usedNodes_;
  place.nodes = {nodes, counters.maxNodes};
  maps[index].firstNode = shared::uint(usedNodes_);
  gatherNodes_({"gather nodes", {texels}, {64}}, std::uint32_t(texels), maps[index].firstNode, mapStarts_, firstChunks_,
               chunkNext_, chunkDepths_, chunkValues_, pool_);
  device::copyElements(device_, mapStarts_, 0, texels + 1, starts_, place.firstTexel);
  usedNodes_ += nodes;
  chunksUsed_ += chunks;
  return true;
}

void Chunked::finish() {
  const std::size_t exactSize = poolSize(device_, usedNodes_ + 1);
  if (pool_.size() > exactSize) {
    Nodes exact(device_, exactSize, "pool of nodes");
    device::copyElements(device_, pool_, 0, usedNodes_, exact, 0);
    pool_ = std::move(exact);
  }
  readable_.finish(device_, pool_);
  chunkDepths_ = {};
  chunkValues_ = {};
  chunkNext_ = {};
  firstChunks_ = {};
  nodeCounts_ = {};
  mapStarts_ = {};
}

shared::MemoryParams Chunked::params() const {
  shared::MemoryParams params{};
  params.chunkCapacity = shared::uint(chunkNext_.size());
  return params;
}

device::ArgumentList Chunked::writeArguments() const {
  return {chunkDepths_.cl(), chunkValues_.cl(), chunkNext_.cl(), firstChunks_.cl(), nodeCounts_.cl(), counters_.cl()};
}

device::ArgumentList Chunked::readArguments() const { return {starts_.cl(), readable_.argument()}; }

MemoryStats Chunked::stats() const {
  MemoryStats stats;
  stats.strategy = "chunked";
  stats.bytesReserved = pool_.bytes() + starts_.bytes();
  stats.bytesUsed = usedNodes_ * sizeof(shared::float2) + starts_.bytes();
  stats.bytesWasted = stats.bytesReserved - stats.bytesUsed;
  stats.chunksUsed = chunksUsed_;
  stats.chunksWasted = 0;  // a chunk is handed out to the texel that writes to it at once
  stats.bytesPerNode = sizeof(shared::float2);
  return stats;
}

}  // namespace cdsm::memory
