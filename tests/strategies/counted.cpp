// SPDX-License-Identifier: Apache-2.0
#include "strategies/counted.hpp"

#include <algorithm>

#include "device/copy.hpp"

namespace cdsm::strategies {

void Counted::reserve(std::vector<shared::MapData>& maps, const std::vector<int>& kept) {
  store_.reserve(maps, kept);
  std::size_t texels = 0;
  for (const shared::MapData& map : maps) texels = std::max(texels, std::size_t(map.width) * map.height);
  counts_ = device::Buffer<std::uint32_t>(device_, texels, "nodes per texel");
  starts_ = device::Buffer<std::uint32_t>(device_, texels + 1, "starts of texels");
  fill_ = false;
}

bool Counted::finishMap(std::size_t index, std::vector<shared::MapData>& maps, std::string& why) {
  const std::size_t texels = std::size_t(maps[index].width) * maps[index].height;
  fill_ = !fill_;
  if (fill_) {
    nodes_ = scan_(texels, counts_, starts_);
    store_.makeRoom(nodes_);
    why = std::to_string(nodes_) + " nodes counted; map built again to fill them in";
    return false;
  }
  const std::vector<std::uint32_t> counts = counts_.download(texels);
  store_.add(index, maps[index], nodes_, {nodes_, *std::max_element(counts.begin(), counts.end())}, texels + 1);
  device::copyElements(device_, starts_, 0, texels + 1, store_.table(), maps[index].firstTexel);
  return true;
}

shared::MemoryParams Counted::params() const {
  shared::MemoryParams params{};
  params.firstNode = shared::uint(store_.nextNode());
  params.fill = fill_;
  return params;
}

device::ArgumentList Counted::writeArguments() const { return {store_.nodes().cl(), starts_.cl(), counts_.cl()}; }

}  // namespace cdsm::strategies
