// SPDX-License-Identifier: Apache-2.0
#include "memory/chunked.hpp"

#include <algorithm>
#include <utility>

#include "device/copy.hpp"
#include "device/program.hpp"

namespace cdsm::memory {

Chunked::Chunked(device::Device& device, const NodeFormat& format)
    : MemoryStrategy(device, format),
      device_(device),
      scan_(device),
      store_(device, format),
      counters_(device, 1, "build counters"),
      gatherNodes_(device,
                   device.programs().get({"memory/gather_nodes.cl",
                                          {nodeFormatDefine(format), spectrumDefine(spectrumNamed(format.spectrum))},
                                          {}}),
                   "gatherNodes") {}

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
  chunkValues_ =
      Floats(device_, spectrumNamed(format().spectrum).stride * chunks * CDSM_CHUNK_NODES, "transmittances of chunks");
  chunkNext_ = Uints(device_, chunks, "links of chunks");
}

void Chunked::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  store_.reserve(maps, kept);
  std::size_t texels = 0;
  for (const shared::MapData& map : maps) texels = std::max(texels, std::size_t(map.width) * map.height);
  firstChunks_ = Uints(device_, texels, "first chunks of texels");
  nodeCounts_ = Uints(device_, texels, "nodes per texel");
  mapStarts_ = Uints(device_, texels + 1, "starts of texels");
  reserveChunks(std::max(texels, chunkRoom_));
  chunksUsed_ = 0;
}

void Chunked::beginMap() { counters_.fill({}); }

bool Chunked::finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) {
  const shared::BuildCounters counters = counters_.read(0);
  const std::size_t chunks = counters.chunks, room = chunkNext_.size();
  if (chunks > room) {
    why = "room for chunks grown from " + std::to_string(room) + " to " + std::to_string(chunks) + "; map built again";
    reserveChunks(chunks);
    return false;
  }
  shared::MapData& map = maps[index];
  const std::size_t texels = std::size_t(map.width) * map.height;
  const std::size_t nodes = scan_(texels, nodeCounts_, mapStarts_);
  store_.makeRoom(nodes);
  store_.add(index, map, nodes, {nodes, counters.maxNodes}, texels + 1);
  gatherNodes_({"gather nodes", {texels}, {64}}, std::uint32_t(texels), map.firstNode, mapStarts_, firstChunks_,
               chunkNext_, chunkDepths_, chunkValues_, store_.nodes());
  device::copyElements(device_, mapStarts_, 0, texels + 1, store_.table(), map.firstTexel);
  chunksUsed_ += chunks;
  return true;
}

void Chunked::finish() {
  store_.finish();
  chunkDepths_ = {};
  chunkValues_ = {};
  chunkNext_ = {};
  firstChunks_ = {};
  nodeCounts_ = {};
  mapStarts_ = {};
}

shared::MemoryParams Chunked::params() const {
  shared::MemoryParams params{};
  params.capacity = shared::uint(chunkNext_.size());
  return params;
}

device::ArgumentList Chunked::writeArguments() const {
  return {chunkDepths_.cl(), chunkValues_.cl(), chunkNext_.cl(), firstChunks_.cl(), nodeCounts_.cl(), counters_.cl()};
}

device::ArgumentList Chunked::readArguments() const { return {store_.table().cl(), store_.readable()}; }

MemoryStats Chunked::stats() const {
  MemoryStats stats = store_.stats("chunked");
  stats.chunksUsed = chunksUsed_;
  stats.chunksWasted = 0;  // a chunk is handed out to the texel that writes to it at once
  return stats;
}

}  // namespace cdsm::memory
