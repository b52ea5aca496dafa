// SPDX-License-Identifier: Apache-2.0
// Triangles or spheres on the screen -> (coverage mask, owner) pairs in exactly sized lists, one per 8x8 tile of the
// view [Knecht 2011, §3.1.1, §4.1.1]. The thesis's chunks of 64 pairs are replaced by counting first: no limit per
// tile. countPairs -> (scan) -> fillPairs, each once for small primitives and once for large ones. CDSM_PRIMITIVE: what
// they are, ScreenPrimitive and its Coverage.
#include CDSM_PRIMITIVE
#include "build/coverage.clh"
#include "build/screen_slot.clh"
#include "common/inline.clh"

/// Pixels of a tile that are covered and inside of the view.
CDSM_INLINE ulong maskInView(const Coverage* coverage, int tileX, int tileY, const ViewData* view) {
  int x = tileX * CDSM_TILE, y = tileY * CDSM_TILE;
  return tileMask(coverage, x, y, view) & insideView(x, y, view->width, view->height);
}

/// Adds one tile of a primitive to the counts.
CDSM_INLINE void countTile(const Coverage* coverage, int tileX, int tileY, const ViewData* view,
                           __global uint* tilePairs) {
  if (!takesPair(maskInView(coverage, tileX, tileY, view))) return;
  uint tile = (uint)(tileY * view->tilesX + tileX);
  atomic_inc(&tilePairs[tile]);
}

/// Writes one tile's pair, and counts its fragments. Pairs of a tile lie in any order: each pixel sorts what covers it.
CDSM_INLINE void fillTile(const Coverage* coverage, int tileX, int tileY, const ViewData* view, uint owner,
                          __global const uint* tileStart, __global uint* tileCursor, __global uint* tileFragments,
                          __global ulong* masks, __global uint* owners) {
  ulong mask = maskInView(coverage, tileX, tileY, view);
  if (!takesPair(mask)) return;
  uint tile = (uint)(tileY * view->tilesX + tileX);
  uint place = tileStart[tile] + atomic_inc(&tileCursor[tile]);
  masks[place] = mask;
  owners[place] = owner;
  atomic_add(&tileFragments[tile], (uint)popcount(mask) << ((owner & CDSM_TWICE_BIT) ? 1 : 0));
}

/// A work item per primitive that is not large.
__kernel void countPairs(SetupParams params, ViewData view, __global const ScreenPrimitive* screen,
                         __global const RasterCounters* counters, __global uint* tilePairs) {
  uint slot = (uint)get_global_id(0);
  if (slot >= min(counters->wanted, params.capacity)) return;
  int4 tiles = coveredTiles(&screen[slot], &view);
  if (isLarge(tiles)) return;
  Coverage coverage = coverageOf(&screen[slot]);
  for (int y = tiles.y; y <= tiles.w; ++y)
    for (int x = tiles.x; x <= tiles.z; ++x) countTile(&coverage, x, y, &view, tilePairs);
}

/// Work groups take large primitives in turn, their items the tiles of each.
__kernel void countPairsLarge(SetupParams params, ViewData view, __global const ScreenPrimitive* screen,
                              __global const RasterCounters* counters, __global const uint* large,
                              __global uint* tilePairs) {
  for (uint i = (uint)get_group_id(0); i < counters->large; i += (uint)get_num_groups(0)) {
    __global const ScreenPrimitive* p = &screen[large[i]];
    int4 tiles = coveredTiles(p, &view);
    Coverage coverage = coverageOf(p);
    int columns = tiles.z - tiles.x + 1, total = columns * (tiles.w - tiles.y + 1);
    for (int k = (int)get_local_id(0); k < total; k += (int)get_local_size(0))
      countTile(&coverage, tiles.x + k % columns, tiles.y + k / columns, &view, tilePairs);
  }
}

/// As countPairs, writing.
__kernel void fillPairs(SetupParams params, ViewData view, __global const ScreenPrimitive* screen,
                        __global const RasterCounters* counters, __global const uint* tileStart,
                        __global uint* tileCursor, __global uint* tileFragments, __global ulong* masks,
                        __global uint* owners) {
  uint slot = (uint)get_global_id(0);
  if (slot >= min(counters->wanted, params.capacity)) return;
  int4 tiles = coveredTiles(&screen[slot], &view);
  if (isLarge(tiles)) return;
  Coverage coverage = coverageOf(&screen[slot]);
  uint owner = ownerOf(&screen[slot], slot);
  for (int y = tiles.y; y <= tiles.w; ++y)
    for (int x = tiles.x; x <= tiles.z; ++x)
      fillTile(&coverage, x, y, &view, owner, tileStart, tileCursor, tileFragments, masks, owners);
}

/// As countPairsLarge, writing.
__kernel void fillPairsLarge(SetupParams params, ViewData view, __global const ScreenPrimitive* screen,
                             __global const RasterCounters* counters, __global const uint* large,
                             __global const uint* tileStart, __global uint* tileCursor, __global uint* tileFragments,
                             __global ulong* masks, __global uint* owners) {
  for (uint i = (uint)get_group_id(0); i < counters->large; i += (uint)get_num_groups(0)) {
    __global const ScreenPrimitive* p = &screen[large[i]];
    int4 tiles = coveredTiles(p, &view);
    Coverage coverage = coverageOf(p);
    uint owner = ownerOf(p, large[i]);
    int columns = tiles.z - tiles.x + 1, total = columns * (tiles.w - tiles.y + 1);
    for (int k = (int)get_local_id(0); k < total; k += (int)get_local_size(0))
      fillTile(&coverage, tiles.x + k % columns, tiles.y + k / columns, &view, owner, tileStart, tileCursor,
               tileFragments, masks, owners);
  }
}
