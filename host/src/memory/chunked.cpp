// SPDX-License-Identifier: Apache-2.0
#include "memory/chunked.hpp"

#include <algorithm>

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
  chunkDepths_ = Floats(device_, chunks * CDSM_CHUNK_NODES, "depths of chunks");
  chunkValues_ = Floats(device_, chunks * CDSM_CHUNK_NODES, "transmittances of chunks");
  chunkNext_ = Uints(device_, chunks, "links of chunks");
}

void Chunked::reserve(std::vector<shared::MapData>& maps) {
  std::size_t entries = 0, texels = 0;
  for (shared::MapData& map : maps) {
    texels = std::max(texels, std::size_t(map.width) * map.height);
    map.firstTexel = shared::uint(entries);
    entries += std::size_t(map.width) * map.height + 1;
  }
  if (entries > 0xffffffffu)
    throw DeviceError("the lookup table needs " + std::to_string(entries) +
                      " entries, more than 2^32; take smaller maps or fewer lights");
  starts_ = {};
  starts_ = Uints(device_, entries, "lookup table");
  firstChunks_ = Uints(device_, texels, "first chunks of texels");
  nodeCounts_ = Uints(device_, texels, "nodes per texel");
  mapStarts_ = Uints(device_, texels + 1, "starts of texels");
  reserveChunks(std::max<std::size_t>(texels, 1024));
  totals_.assign(maps.size(), {});
  usedNodes_ = 0;
  chunksUsed_ = 0;
}

void Chunked::beginMap() { counters_.fill({}); }

void Chunked::growPool(std::size_t nodes, std::size_t kept) {
  ++nodes;  // one more: a texel without nodes reads the one behind its place, and ignores it
  if (poolSize(device_, nodes) <= pool_.size()) return;
  if (nodes > 0xffffffffu)
    throw DeviceError("the maps need " + std::to_string(nodes) +
                      " nodes, more than 2^32; take smaller maps or a larger tolerance");
  Nodes larger(device_, poolSize(device_, nodes), "pool of nodes");
  device::copyElements(device_, pool_, kept, larger, 0);
  pool_ = std::move(larger);
}

MapOutcome Chunked::finishMap(std::size_t index, shared::MapData& map, std::string& why) {
  const shared::BuildCounters counters = counters_.read(0);
  const std::size_t chunks = counters.chunks, room = chunkNext_.size();
  if (chunks > room) {
    why = "room for chunks grown from " + std::to_string(room) + " to " + std::to_string(chunks) + "; map built again";
    reserveChunks(chunks);
    return MapOutcome::BuildAgain;
  }
  const std::size_t texels = std::size_t(map.width) * map.height;
  const std::size_t nodes = scan_(texels, nodeCounts_, mapStarts_);
  growPool(usedNodes_ + nodes, usedNodes_);
  map.firstNode = shared::uint(usedNodes_);
  gatherNodes_({"gather nodes", {texels}, {64}}, std::uint32_t(texels), map.firstNode, mapStarts_, firstChunks_,
               chunkNext_, chunkDepths_, chunkValues_, pool_);
  device::copyElements(device_, mapStarts_, texels + 1, starts_, map.firstTexel);
  totals_[index] = {nodes, counters.maxNodes};
  usedNodes_ += nodes;
  chunksUsed_ += chunks;
  return MapOutcome::Complete;
}

void Chunked::finish() {
  growPool(usedNodes_, usedNodes_);
  const std::size_t exactSize = poolSize(device_, usedNodes_ + 1);
  if (pool_.size() > exactSize) {
    Nodes exact(device_, exactSize, "pool of nodes");
    device::copyElements(device_, pool_, usedNodes_, exact, 0);
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
