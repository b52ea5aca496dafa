// SPDX-License-Identifier: Apache-2.0
// Strategy "exact": the table of a finished map with 16-bit entries (memory/exact.clh).
#include "shared/map_data.h"
#include "shared/view_data.h"

/// A work item per tile. Its nodes are fewer than 2^16.
__kernel void narrowTable(uint tileCount, __global const uint* wide, __global uint* table, uint firstWord) {
  uint tile = (uint)get_global_id(0);
  if (tile >= tileCount) return;
  __global const uint* starts = wide + tile * CDSM_EXACT_WORDS;
  __global uint* record = table + firstWord + tile * CDSM_EXACT_NARROW_WORDS;
  __global ushort* entries = (__global ushort*)(record + 1);
  record[0] = starts[0];
  for (uint i = 0; i <= CDSM_TILE_PIXELS; ++i) entries[i] = (ushort)(starts[i] - starts[0]);
  entries[CDSM_TILE_PIXELS + 1] = 0;  // fills the last word
}
