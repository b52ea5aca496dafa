// SPDX-License-Identifier: Apache-2.0
#include "memory/atlas.hpp"

#include <algorithm>
#include <utility>

#include "device/copy.hpp"

namespace cdsm::memory {

namespace {

constexpr int kFirstLayers = 16;   ///< enough for most scenes at tolerance 0.01; even
constexpr int kMostTexels = 2048;  ///< t_max, along x and y [Knecht 2011, eq. 4.7]

}  // namespace

Atlas::Atlas(device::Device& device, const NodeFormat& format)
    : MemoryStrategy(device, format), device_(device), layers_(kFirstLayers), counters_(device, 1, "build counters") {}

void Atlas::arrange(std::vector<shared::MapData>& maps) {
  const int count = std::max(1, int(maps.size())), columns = std::max(1, kMostTexels / side_);
  // maps fill rows, then columns, then go on behind the layers of the first ones [Knecht 2011, eqs. 4.7, 4.8]
  size_.x = side_ * std::min(count, columns);
  size_.y = side_ * std::min((count + columns - 1) / columns, columns);
  size_.z = layers_;
  size_.w = layers_ * ((count + columns * columns - 1) / (columns * columns));
  for (int i = 0; i < int(maps.size()); ++i) {
    maps[i].atlasOffset = {side_ * (i % columns), side_ * (i / columns % columns), layers_ * (i / (columns * columns)),
                           0};
    maps[i].firstTexel = shared::uint(i) * shared::uint(side_) * shared::uint(side_);
    placed_[i].offset = maps[i].atlasOffset;
  }
}

void Atlas::moveNodes(const std::vector<Place>& before, const std::vector<int>& from, const shared::int4& sizeBefore) {
  const std::size_t nodes = poolSize(device_, format(), std::size_t(size_.x) * size_.y * size_.w);
  if (nodes > 0xffffffffu)
    throw DeviceError("the atlas needs " + std::to_string(nodes) +
                      " nodes, more than 2^32; take smaller maps, a larger tolerance or another memory strategy");
  const std::size_t texels = std::size_t(side_) * side_, pair = 2 * format().words;  // in values of the buffer
  bool inPlace = nodes_.size() == nodes * format().words && counts_.size() == texels * placed_.size();
  bool none = true;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == kBuildAnew) continue;
    none = false;
    inPlace =
        inPlace && from[i] == int(i) && sizeBefore.x == size_.x && sizeBefore.y == size_.y && sizeBefore.z == size_.z;
  }
  if (inPlace) return;
  if (none) {
    nodes_ = {};
    counts_ = {};
  }
  NodeBuffer moved(device_, nodes * format().words, "atlas of nodes");
  device::Buffer<std::uint32_t> counts(device_, texels * placed_.size(), "nodes per texel");
  const std::size_t layers = std::size_t(std::min(sizeBefore.z, size_.z)) / 2;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == kBuildAnew) continue;
    const auto placeIn = [&](const shared::int4& size, const shared::int4& offset) {
      return device::GridPlace{pair * std::size_t(offset.x), std::size_t(offset.y), std::size_t(offset.z) / 2,
                               pair * std::size_t(size.x), std::size_t(size.y)};
    };
    device::copyBox(device_, nodes_, placeIn(sizeBefore, before[from[i]].offset), moved,
                    placeIn(size_, placed_[i].offset), {pair * std::size_t(side_), std::size_t(side_), layers});
    device::copyElements(device_, counts_, std::size_t(from[i]) * texels, texels, counts, i * texels);
  }
  nodes_ = std::move(moved);
  counts_ = std::move(counts);
}

void Atlas::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  const std::vector<Place> before = std::exchange(placed_, std::vector<Place>(maps.size()));
  const shared::int4 sizeBefore = size_;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i] != kBuildAnew) placed_[i] = before[kept[i]];
  side_ = maps.empty() ? 1 : maps[0].width;
  arrange(maps);
  moveNodes(before, kept, sizeBefore);
}

void Atlas::beginMap() { counters_.fill({}); }

bool Atlas::finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) {
  const int most = int(counters_.read(0).maxNodes);
  if (most > layers_) {
    why = "layers of the atlas raised from " + std::to_string(layers_) + " to " + std::to_string(most) +
          ", a texel needs them; map built again";
    layers_ = (most + 1) / 2 * 2;
    const std::vector<Place> before = placed_;
    const shared::int4 sizeBefore = size_;
    std::vector<int> from;
    for (std::size_t i = 0; i < placed_.size(); ++i) from.push_back(placed_[i].filled ? int(i) : kBuildAnew);
    arrange(maps);
    moveNodes(before, from, sizeBefore);
    return false;
  }
  const std::size_t texels = std::size_t(side_) * side_;
  Place& place = placed_[index];
  place.filled = true;
  place.nodes = {};
  for (const std::uint32_t count : counts_.download(texels, index * texels)) {
    place.nodes.total += count;
    place.nodes.most = std::max<std::uint64_t>(place.nodes.most, count);
  }
  return true;
}

void Atlas::finish() { readable_.finish(device_, format(), nodes_); }

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
  for (const Place& map : placed_) stats.bytesUsed += map.nodes.total * format().bytes();
  stats.bytesWasted = stats.bytesReserved - stats.bytesUsed;
  stats.bytesPerNode = double(format().bytes());
  return stats;
}

}  // namespace cdsm::memory
