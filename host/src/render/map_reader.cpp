// SPDX-License-Identifier: Apache-2.0
#include "render/map_reader.hpp"

namespace cdsm::render {

namespace {

/// `values`: of each node `floats`, its depth first.
void takeNodes(const std::vector<float>& values, std::size_t count, std::size_t floats, LightMap& map) {
  map.nodes.clear();
  map.colors.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const float* node = &values[floats * i];
    if (floats == 2) {
      map.nodes.push_back({node[0], node[1]});
    } else {
      map.nodes.push_back({node[0], (node[1] + node[2] + node[3]) / 3.0f});
      map.colors.emplace_back(node[1], node[2], node[3]);
    }
  }
}

}  // namespace

void MapReader::run(const Scene& scene, const build::DeviceScene& deviceScene,
                    const technique::ShadowTechnique& technique, std::size_t index, LightMap& map) {
  using Uints = device::Buffer<std::uint32_t>;
  using Floats = device::Buffer<float>;
  const cl::Program& program = build::sceneProgram(device_, deviceScene, "render/read_map.cl", technique.kernelFiles());
  const shared::MemoryParams memory = technique.params(scene).memory;
  const std::size_t texels = std::size_t(map.width) * map.height;
  const Uints counts(device_, texels, "nodes per texel");
  device::Kernel<std::uint32_t, shared::MemoryParams, Uints, device::ArgumentList> countMapNodes(device_, program,
                                                                                                 "countMapNodes");
  countMapNodes({"count map nodes", {texels}, {64}}, std::uint32_t(index), memory, counts, technique.arguments());

  Uints starts(device_, texels + 1, "first nodes");
  const std::size_t count = scan_(texels, counts, starts), floats = 1 + deviceScene.spectrum().channels;
  const Floats nodes(device_, floats * count, "nodes of a map");
  device::Kernel<std::uint32_t, shared::MemoryParams, Uints, Floats, device::ArgumentList> copyMapNodes(
      device_, program, "copyMapNodes");
  copyMapNodes({"copy map nodes", {texels}, {64}}, std::uint32_t(index), memory, starts, nodes, technique.arguments());

  map.firstNode = starts.download();
  takeNodes(nodes.download(), count, floats, map);
}

}  // namespace cdsm::render
