// SPDX-License-Identifier: Apache-2.0
// Pairs of each tile -> fragments of each pixel, sorted from near to far by full float depth, then by triangle number
// [Knecht 2011, §3.1.2, §4.1.2, with 64-bit keys instead of 16 + 16 bits].
#include "common/affine.clh"
#include "common/sort.clh"
#include "shared/layer_data.h"

/// Depth at which the pixel's ray meets the triangle's plane; kept within the triangle, which edge-on planes leave.
float fragmentDepth(const ViewData* view, const Ray* ray, __global const ScreenTriangle* t) {
  float3 normal = t->plane.xyz;
  float along = dot(normal, ray->dir);
  float depth = (t->plane.w - dot(normal, ray->origin - view->origin.xyz)) / along;
  return along == 0.0f ? t->maxDepth : clamp(depth, t->minDepth, t->maxDepth);
}

/// Key of a fragment: depth (positive floats order as their bits do), then triangle number and facing.
ulong fragmentKey(float depth, uint facing) { return ((ulong)as_uint(max(depth, 0.0f)) << 32) | facing; }

/// A group per tile, an item per pixel. A pixel's range: `initialCount` slots for the objects that contain the eye (used
/// by segments.clh for its list of entered objects), then its fragments. ranges[pixel] = (first slot, fragments).
__kernel void sortFragments(ViewData view, __global const ScreenTriangle* screen, __global const uint* tileStart,
                            __global const uint* tileFragmentStart, __global const ulong* masks,
                            __global const uint* owners, __global ulong* fragments, __global uint2* ranges) {
  __local uint counts[CDSM_TILE_PIXELS];
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  uint firstPair = tileStart[tile], lastPair = tileStart[tile + 1];
  ulong bit = 1UL << pixel;
  uint count = 0;
  for (uint i = firstPair; i < lastPair; ++i) count += (masks[i] & bit) ? 1u : 0u;
  counts[pixel] = count;
  barrier(CLK_LOCAL_MEM_FENCE);

  uint first = tileFragmentStart[tile] + tile * CDSM_TILE_PIXELS * view.initialCount + pixel * view.initialCount;
  for (uint i = 0; i < pixel; ++i) first += counts[i];
  int x = (int)(tile % (uint)view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  ranges[tile * CDSM_TILE_PIXELS + pixel] = (uint2)(first, count);
  Ray ray = rayThroughPixel(&view, x + 0.5f, y + 0.5f);
  __global ulong* keys = fragments + first + view.initialCount;
  uint written = 0;
  for (uint i = firstPair; i < lastPair && written < count; ++i)
    if (masks[i] & bit) {
      __global const ScreenTriangle* t = &screen[owners[i]];
      keys[written++] = fragmentKey(fragmentDepth(&view, &ray, t), t->facing);
    }
  sortKeys(keys, count);
}
