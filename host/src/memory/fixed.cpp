// SPDX-License-Identifier: Apache-2.0
#include "memory/fixed.hpp"

#include <algorithm>
#include <utility>

namespace cdsm::memory {

Fixed::Fixed(device::Device& device, const NodeFormat& format, int nodesPerTexel)
    : MemoryStrategy(device, format),
      device_(device),
      store_(device, format),
      nodesPerTexel_(std::size_t(nodesPerTexel)) {}

void Fixed::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  store_.reserve(maps, kept);
  const std::vector<float> before = std::exchange(mergeErrors_, std::vector<float>(maps.size(), 0.0f));
  texels_ = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    texels_ = std::max(texels_, std::size_t(maps[i].width) * maps[i].height);
    if (kept[i] != kBuildAnew) mergeErrors_[i] = before[kept[i]];
  }
  pieceErrors_ = device::Buffer<float>(device_, texels_ * nodesPerTexel_, "errors of merged nodes");
  nodeCounts_ = device::Buffer<std::uint32_t>(device_, texels_, "nodes per texel");
  texelErrors_ = device::Buffer<float>(device_, texels_, "errors of texels");
}

void Fixed::beginMap() { store_.makeRoom(texels_ * nodesPerTexel_); }

bool Fixed::finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string&) {
  const std::size_t texels = std::size_t(maps[index].width) * maps[index].height;
  NodeCounts counts;
  for (const std::uint32_t count : nodeCounts_.download(texels)) {
    counts.total += count;
    counts.most = std::max<std::uint64_t>(counts.most, count);
  }
  for (const float error : texelErrors_.download(texels)) mergeErrors_[index] = std::max(mergeErrors_[index], error);
  store_.add(index, maps[index], texels * nodesPerTexel_, counts, 0);
  return true;
}

void Fixed::finish() {
  store_.finish();
  pieceErrors_ = {};
  nodeCounts_ = {};
  texelErrors_ = {};
}

shared::MemoryParams Fixed::params() const {
  shared::MemoryParams params{};
  params.firstNode = shared::uint(store_.nextNode());
  params.nodesPerTexel = shared::uint(nodesPerTexel_);
  return params;
}

device::ArgumentList Fixed::writeArguments() const {
  return {store_.nodes().cl(), pieceErrors_.cl(), nodeCounts_.cl(), texelErrors_.cl()};
}

MemoryStats Fixed::stats() const {
  MemoryStats stats = store_.stats("fixed");
  for (const float error : mergeErrors_) stats.mergeError = std::max(stats.mergeError, double(error));
  stats.mergeError = std::min(stats.mergeError, 1.0);
  return stats;
}

}  // namespace cdsm::memory
