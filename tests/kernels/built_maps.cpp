// SPDX-License-Identifier: Apache-2.0
#include "built_maps.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "cluster/light_camera.hpp"
#include "memory/atlas.hpp"
#include "memory/chunked.hpp"
#include "memory/exact.hpp"
#include "memory/fixed.hpp"
#include "memory/tiled.hpp"
#include "strategies/counted.hpp"

namespace cdsm::kernels {
namespace {

using Uints = device::Buffer<std::uint32_t>;
using memory::TileStrategy;

const char* const kText = R"(
#include CDSM_MEMORY
__kernel void countNodes(uint mapIndex, __global const MapData* maps, __global uint* counts, MemoryParams memory,
                         CDSM_MEMORY_READ_BUFFERS) {
  __global const MapData* map = &maps[mapIndex];
  int i = (int)get_global_id(0);
  if (i >= map->width * map->height) return;
  counts[i] = texelNodes(map, i % map->width, i / map->width, CDSM_MEMORY_READ_ARGS).count;
}
__kernel void readNodes(uint mapIndex, __global const MapData* maps, __global const uint* starts, __global Node* nodes,
                        MemoryParams memory, CDSM_MEMORY_READ_BUFFERS) {
  __global const MapData* map = &maps[mapIndex];
  int i = (int)get_global_id(0);
  if (i >= map->width * map->height) return;
  TexelNodes t = texelNodes(map, i % map->width, i / map->width, CDSM_MEMORY_READ_ARGS);
  for (uint k = 0; k < t.count; ++k) nodes[starts[i] + k] = readNode(t.first, k, CDSM_MEMORY_READ_ARGS);
}
)";

template <class Made>
Strategy plain(const std::string& name) {
  return {name, [](device::Device& device, const memory::NodeFormat& format) {
            return std::make_unique<Made>(device, format);
          }};
}

template <class Made>
Strategy twoPasses(const std::string& name) {
  return {name, [](device::Device& device, const memory::NodeFormat& format) {
            return std::make_unique<Made>(device, format, TileStrategy::Mode::Count);
          }};
}

/// Without repetitions of the last node, and without nodes that do not attenuate if there are no others.
Nodes withoutPadding(Nodes nodes) {
  const auto same = [](const shared::float2& a, const shared::float2& b) { return a.x == b.x && a.y == b.y; };
  while (nodes.size() > 1 && same(nodes[nodes.size() - 1], nodes[nodes.size() - 2])) nodes.pop_back();
  if (nodes.size() == 1 && nodes[0].y == 1.0f) nodes.clear();
  return nodes;
}

}  // namespace

const std::vector<Strategy>& exactStrategies() {
  static const std::vector<Strategy> list{
      plain<memory::Chunked>("chunked"),    plain<memory::Atlas>("atlas"),
      plain<memory::Exact>("exact"),        twoPasses<memory::Exact>("exactInTwoPasses"),
      plain<memory::Tiled>("tiled"),        twoPasses<memory::Tiled>("tiledInTwoPasses"),
      plain<strategies::Counted>("counted")};
  return list;
}

Strategy fixedStrategy(int nodesPerTexel) {
  return {"fixed" + std::to_string(nodesPerTexel), [=](device::Device& device, const memory::NodeFormat& format) {
            return std::make_unique<memory::Fixed>(device, format, nodesPerTexel);
          }};
}

Strategy strategyNamed(const std::string& name) {
  for (const Strategy& strategy : exactStrategies())
    if (strategy.name == name) return strategy;
  throw Error("no strategy '" + name + "' in this test");
}

MapBuilder::MapBuilder(const Strategy& strategy, const std::string& fetch, const std::string& format)
    : device_(deviceOf(fetch)),
      memory_(strategy.make(device_, memory::nodeFormat(format, "grey"))),
      raster_(device_),
      pass_(device_) {}

void MapBuilder::build(const std::vector<Scene>& scenes, int size, std::vector<int> kept) {
  build::DeviceScene onDevice(device_);
  onDevice.update(scenes.front());
  std::vector<unsigned> casters(scenes.front().meshes.size() + scenes.front().volumes.size());
  std::iota(casters.begin(), casters.end(), 0u);
  kept.resize(scenes.size(), memory::kBuildAnew);
  std::vector<build::MapJob> jobs;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const shared::ViewData view = cluster::lightViews(scenes[i].lights.front(), onDevice.bounds(), size).front();
    const auto map = kept[i] >= 0 ? maps_[std::size_t(kept[i])] : cluster::mapData(view, CDSM_FACE_ANY);
    jobs.push_back({map, view, casters, kept[i]});
  }
  reports_.clear();
  maps_ = pass_.run(onDevice, jobs, {scenes.front().shadows.tolerance, false}, raster_, *memory_,
                    [this](const std::string& what) { reports_.push_back(what); });
}

Texels MapBuilder::read(std::size_t map) {
  Defines defines = build::memoryDefines(*memory_);
  const memory::Spectrum& spectrum = memory::spectrumNamed(memory_->format().spectrum);
  defines.push_back(memory::spectrumDefine(spectrum));
  defines.emplace_back("CDSM_TILE_CHUNKS", std::to_string(memory::tileChunks(device_, spectrum)));
  if (device_.fetchImages()) defines.emplace_back("CDSM_FETCH_IMAGE", "1");
  const cl::Program& program = testProgram(device_, kText, defines);
  const auto maps = device::Buffer<shared::MapData>::fromHost(device_, maps_, "maps");
  const std::size_t texels = std::size_t(maps_[map].width) * maps_[map].height;
  Uints counts(device_, texels, "counts");
  device::Kernel<std::uint32_t, device::Buffer<shared::MapData>, Uints, shared::MemoryParams, device::ArgumentList>
      count(device_, program, "countNodes");
  count({"count", {texels}, {kGroup}}, std::uint32_t(map), maps, counts, memory_->params(), memory_->readArguments());
  std::vector<std::uint32_t> starts{0};
  for (const std::uint32_t n : counts.download()) starts.push_back(starts.back() + n);
  const auto from = Uints::fromHost(device_, starts, "starts");
  device::Buffer<shared::float2> nodes(device_, starts.back(), "nodes");
  device::Kernel<std::uint32_t, device::Buffer<shared::MapData>, Uints, device::Buffer<shared::float2>,
                 shared::MemoryParams, device::ArgumentList>
      read(device_, program, "readNodes");
  read({"read", {texels}, {kGroup}}, std::uint32_t(map), maps, from, nodes, memory_->params(),
       memory_->readArguments());
  const Nodes all = nodes.download();
  Texels result;
  for (std::size_t i = 0; i < texels; ++i)
    result.push_back(withoutPadding(Nodes(all.begin() + starts[i], all.begin() + starts[i + 1])));
  return result;
}

std::vector<std::pair<float, float>> MapBuilder::tileDepths(std::size_t map) const {
  std::vector<std::pair<float, float>> scales;
  for (const shared::float2& scale : memory_->tileDepths().download(maps_[map])) scales.emplace_back(scale.x, scale.y);
  return scales;
}

}  // namespace cdsm::kernels
