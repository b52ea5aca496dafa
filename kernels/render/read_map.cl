// SPDX-License-Identifier: Apache-2.0
// Nodes of a finished map, however they are stored -> plain arrays, texel after texel.
#include CDSM_MEMORY

/// A work item per texel of map `index`.
__kernel void countMapNodes(uint index, MemoryParams memory, __global uint* counts, __global const MapData* maps,
                            CDSM_MEMORY_READ_BUFFERS CDSM_TILE_DEPTHS_PARAM) {
  int texel = (int)get_global_id(0), width = maps[index].width;
  if (texel >= width * maps[index].height) return;
  counts[texel] = texelNodes(&maps[index], texel % width, texel / width, CDSM_MEMORY_READ_ARGS).count;
}

/// `starts`: prefix sums of the counts.
__kernel void copyMapNodes(uint index, MemoryParams memory, __global const uint* starts, __global Node* nodes,
                           __global const MapData* maps, CDSM_MEMORY_READ_BUFFERS CDSM_TILE_DEPTHS_PARAM) {
  int texel = (int)get_global_id(0), width = maps[index].width;
  if (texel >= width * maps[index].height) return;
  DepthScale scale = depthScale(&maps[index], texel % width, texel / width CDSM_TILE_DEPTHS_ARG);
  TexelNodes from = texelNodes(&maps[index], texel % width, texel / width, CDSM_MEMORY_READ_ARGS);
  for (uint i = 0; i < from.count; ++i) {
    Node node = readNode(from.first, i, CDSM_MEMORY_READ_ARGS);
    nodes[starts[texel] + i] = (Node)(depthOfStored(scale, node.x), nodeTransmittance(node));
  }
}
