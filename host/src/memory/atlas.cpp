// SPDX-License-Identifier: Apache-2.0
#include "memory/atlas.hpp"

#include <algorithm>

namespace cdsm::memory {

namespace {

constexpr int kFirstLayers = 16;   ///< enough for most scenes at tolerance 0.01; even
constexpr int kMostTexels = 2048;  ///< t_max, along x and y [Knecht 2011, eq. 4.7]

}  // namespace

Atlas::Atlas(device::Device& device) : device_(device), layers_(kFirstLayers), counters_(device, 1, "build counters") {}

void Atlas::reserve(std::vector<shared::MapData>& maps) {
  const int count = std::max(1, int(maps.size())), side = maps.empty() ? 1 : maps[0].width;
  const int columns = std::max(1, kMostTexels / side);
  // maps fill rows, then columns, then go on behind the layers of the first ones [Knecht 2011, eqs. 4.7, 4.8]
  size_.x = side * std::min(count, columns);
  size_.y = side * std::min((count + columns - 1) / columns, columns);
  size_.z = layers_;
  size_.w = layers_ * ((count + columns * columns - 1) / (columns * columns));
  for (int i = 0; i < int(maps.size()); ++i) {
    maps[i].atlasOffset = {side * (i % columns), side * (i / columns % columns), layers_ * (i / (columns * columns)),
                           0};
    maps[i].firstTexel = shared::uint(i) * shared::uint(side) * shared::uint(side);
  }
  const std::size_t nodes = poolSize(device_, std::size_t(size_.x) * size_.y * size_.w);
  if (nodes > 0xffffffffu)
    throw DeviceError("the atlas needs " + std::to_string(nodes) +
                      " nodes, more than 2^32; take smaller maps, a larger "
                      "tolerance or another memory strategy");
  if (nodes_.size() != nodes) {
    nodes_ = {};
    nodes_ = device::Buffer<shared::float2>(device_, nodes, "atlas of nodes");
  }
  counts_ = device::Buffer<std::uint32_t>(device_, std::size_t(side) * side * maps.size(), "nodes per texel");
  totals_.assign(maps.size(), {});
}

void Atlas::beginMap() { counters_.fill({}); }

MapOutcome Atlas::finishMap(std::size_t index, shared::MapData& map, std::string& why) {
  const int most = int(counters_.read(0).maxNodes);
  if (most > layers_) {
    why = "layers of the atlas raised from " + std::to_string(layers_) + " to " + std::to_string(most) +
          ", a texel needs them; maps built again";
    layers_ = (most + 1) / 2 * 2;
    return MapOutcome::BuildAllAgain;
  }
  const std::size_t texels = std::size_t(map.width) * map.height;
  NodeCounts& total = totals_[index];
  for (const std::uint32_t count : counts_.download(texels, map.firstTexel)) {
    total.total += count;
    total.most = std::max<std::uint64_t>(total.most, count);
  }
  return MapOutcome::Complete;
}

void Atlas::finish() { readable_.finish(device_, nodes_); }

shared::MemoryParams Atlas::params() const {
  shared::MemoryParams params{};
  params.atlasSize = size_;
  return params;
}

device::ArgumentList Atlas::writeArguments() const { return {nodes_.cl(), counts_.cl(), counters_.cl()}; }

device::ArgumentList Atlas::readArguments() const { return {counts_.cl(), readable_.argument()}; }

MemoryStats Atlas::stats() const {
  MemoryStats stats;
  stats.strategy = "atlas";
  stats.bytesReserved = nodes_.bytes() + counts_.bytes();
  stats.bytesUsed = counts_.bytes();
  for (const NodeCounts& map : totals_) stats.bytesUsed += map.total * sizeof(shared::float2);
  stats.bytesWasted = stats.bytesReserved - stats.bytesUsed;
  stats.bytesPerNode = sizeof(shared::float2);
  return stats;
}

}  // namespace cdsm::memory
