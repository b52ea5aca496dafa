// SPDX-License-Identifier: Apache-2.0
#include "render/map_reader.hpp"

namespace cdsm::render {

void MapReader::run(const Scene& scene, const build::DeviceScene& deviceScene,
                    const technique::ShadowTechnique& technique, std::size_t index, LightMap& map) {
  using Uints = device::Buffer<std::uint32_t>;
  using Nodes = device::Buffer<shared::float2>;
  const cl::Program& program = build::sceneProgram(device_, deviceScene, "render/read_map.cl", technique.kernelFiles());
  const shared::MemoryParams memory = technique.params(scene).memory;
  const std::size_t texels = std::size_t(map.width) * map.height;
  const Uints counts(device_, texels, "nodes per texel");
  device::Kernel<std::uint32_t, shared::MemoryParams, Uints, device::ArgumentList> countMapNodes(device_, program,
                                                                                                 "countMapNodes");
  countMapNodes({"count map nodes", {texels}, {64}}, std::uint32_t(index), memory, counts, technique.arguments());

  Uints starts(device_, texels + 1, "first nodes");
  const Nodes nodes(device_, scan_(texels, counts, starts), "nodes of a map");
  device::Kernel<std::uint32_t, shared::MemoryParams, Uints, Nodes, device::ArgumentList> copyMapNodes(device_, program,
                                                                                                       "copyMapNodes");
  copyMapNodes({"copy map nodes", {texels}, {64}}, std::uint32_t(index), memory, starts, nodes, technique.arguments());

  map.firstNode = starts.download();
  map.nodes.clear();
  for (const shared::float2& node : nodes.download()) map.nodes.push_back({node.x, node.y});
}

}  // namespace cdsm::render
