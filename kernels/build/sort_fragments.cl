// SPDX-License-Identifier: Apache-2.0
// Pairs of each tile -> fragments of each pixel, sorted from near to far by full float depth, then by number
// [Knecht 2011, §3.1.2, §4.1.2, with 64-bit keys instead of 16 + 16 bits]. CDSM_SPHERES: 1 if the view has any.
#include "common/affine.clh"
#include "common/sort.clh"
#include "common/sphere.clh"
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

/// The fragments of a pixel. None lies behind `wall`, that of the nearest opaque sphere so far: no ray
/// gets there, and of a million spheres most lie behind others.
typedef struct FragmentList {
  __global ulong* keys;
  uint count;
  float wall;
} FragmentList;

CDSM_INLINE void addFragment(FragmentList* list, float depth, uint facing, bool opaque) {
  depth = max(depth, 0.0f);
  if (depth > list->wall) return;
  list->keys[list->count++] = fragmentKey(depth, facing);
  if (opaque) list->wall = depth;
}

/// Where the ray enters and leaves a sphere; of an opaque one the first of both that the view sees.
CDSM_INLINE void addSphere(FragmentList* list, const ViewData* view, const Ray* ray,
                           __global const ScreenSphere* sphere) {
  if (sphere->minDepth > list->wall) return;
  float4 s = sphere->sphere;
  SphereCrossings c = crossSphere(s.xyz - (ray->origin - view->origin.xyz), s.w, ray->dir);
  uint enter = sphere->facing & ~1u;
  bool twice = (sphere->facing & 1u) != 0, entered = c.enter >= view->nearDepth;
  if (entered) addFragment(list, c.enter, enter, !twice);
  if ((twice || !entered) && c.leave >= view->nearDepth) addFragment(list, c.leave, enter | 1u, !twice);
}

/// Drops what lies behind the wall, and sorts the rest.
void finishFragments(FragmentList* list) {
  uint kept = 0;
  for (uint i = 0; i < list->count && !isinf(list->wall); ++i)
    if (as_float((uint)(list->keys[i] >> 32)) <= list->wall) list->keys[kept++] = list->keys[i];
  if (!isinf(list->wall)) list->count = kept;
  sortKeys(list->keys, list->count);
}

/// Fragments that a pair gives a pixel at most. Without branches: loops over all pairs of a tile become vectors.
CDSM_INLINE uint fragmentsOf(ulong mask, uint owner, uint pixel) {
  return ((uint)(mask >> pixel) & 1u) << (CDSM_SPHERES ? owner / CDSM_TWICE_BIT & 1u : 0u);
}

/// A group per tile, an item per pixel. A pixel's range: `initialCount` slots for the objects that contain the eye
/// (used by segments.clh for its list of entered objects), then its fragments. ranges[pixel] = (first slot, fragments).
__kernel void sortFragments(ViewData view, __global const ScreenTriangle* screen, __global const ScreenSphere* spheres,
                            __global const uint* tileStart, __global const uint* tileFragmentStart,
                            __global const ulong* masks, __global const uint* owners, __global ulong* fragments,
                            __global uint2* ranges) {
  __local uint counts[CDSM_TILE_PIXELS];
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  uint firstPair = tileStart[tile], lastPair = tileStart[tile + 1];
  ulong bit = 1UL << pixel;
  uint left = 0;
  for (uint i = firstPair; i < lastPair; ++i) left += fragmentsOf(masks[i], owners[i], pixel);
  counts[pixel] = left;
  barrier(CLK_LOCAL_MEM_FENCE);

  uint first = tileFragmentStart[tile] + tile * CDSM_TILE_PIXELS * view.initialCount + pixel * view.initialCount;
  for (uint i = 0; i < pixel; ++i) first += counts[i];
  int x = (int)(tile % (uint)view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  Ray ray = rayThroughPixel(&view, x + 0.5f, y + 0.5f);
  FragmentList list = {fragments + first + view.initialCount, 0, INFINITY};
  for (uint i = firstPair; i < lastPair && left > 0; ++i) {
    if (!(masks[i] & bit)) continue;
    uint owner = owners[i];
    left -= fragmentsOf(masks[i], owner, pixel);
    if (CDSM_SPHERES && (owner & CDSM_SPHERE_BIT) != 0) {
      addSphere(&list, &view, &ray, &spheres[owner & ~(CDSM_SPHERE_BIT | CDSM_TWICE_BIT)]);
    } else {
      __global const ScreenTriangle* t = &screen[owner];
      addFragment(&list, fragmentDepth(&view, &ray, t), t->facing, false);
    }
  }
  finishFragments(&list);
  ranges[tile * CDSM_TILE_PIXELS + pixel] = (uint2)(first, list.count);
}
