// SPDX-License-Identifier: Apache-2.0
// Strategy "chunked": linked chunks -> the nodes of each texel side by side [Knecht 2011, §4.2.2, "The Chunk Texture"].
#include CDSM_NODE_FORMAT

/// A work item per texel. `starts`: prefix sums of the texels' node counts, texelCount + 1 of them.
__kernel void gatherNodes(uint texelCount, uint firstNode, __global const uint* starts,
                          __global const uint* firstChunks, __global const uint* chunkNext,
                          __global const float* chunkDepths, __global const float* chunkValues,
                          __global StoredNode* nodePool) {
  uint texel = (uint)get_global_id(0);
  if (texel >= texelCount) return;
  uint start = starts[texel], count = starts[texel + 1] - start;
  if (count == 0) return;
  uint chunk = firstChunks[texel];
  for (uint i = 0; i < count; ++i) {
    uint place = i % CDSM_CHUNK_NODES;
    if (i > 0 && place == 0) chunk = chunkNext[chunk];
    uint from = chunk * CDSM_CHUNK_NODES + place;
    storeNode(nodePool, firstNode + start + i, (Node)(chunkDepths[from], loadSpectrum(chunkValues, from)));
  }
}
