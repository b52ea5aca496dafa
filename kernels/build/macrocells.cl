// SPDX-License-Identifier: Apache-2.0
// Which parts of a volume are empty under its transfer function: bounds of the values per macrocell, classified, and
// how far the emptiness reaches around each empty cell.
#include "shared/scene_data.h"

/// A work item per cell: 0 if some value within its bounds has extinction, else 1. `solidBefore[i]` counts the table
/// entries before i that are not 0; interpolation also touches the entry above the upper bound, unless it is an entry.
__kernel void classifyCells(CellParams params, __global const float2* bounds, __global const uint* solidBefore,
                            __global uchar* reach) {
  int cell = (int)get_global_id(0);
  if (cell >= params.cells.x * params.cells.y * params.cells.z) return;
  float last = (float)params.lutLast;
  float low = clamp(bounds[cell].x * params.lutScale + params.lutBias, 0.0f, last);
  float high = clamp(bounds[cell].y * params.lutScale + params.lutBias, 0.0f, last);
  uint first = (uint)low, end = (uint)ceil(high) + 1u;
  reach[params.cells.w + cell] = solidBefore[end] == solidBefore[first] ? 1 : 0;
}

/// A work item per cell; one more ring of the cube of empty cells around a cell that was found empty `ring` rings out.
__kernel void growReach(CellParams params, uint ring, __global const uchar* before, __global uchar* reach) {
  int cell = (int)get_global_id(0);
  int4 n = params.cells;
  if (cell >= n.x * n.y * n.z) return;
  __global const uchar* from = before + n.w;
  uchar own = from[cell];
  int3 at = (int3)(cell % n.x, cell / n.x % n.y, cell / (n.x * n.y));
  bool grows = own == ring;
  for (int z = max(at.z - 1, 0); grows && z <= min(at.z + 1, n.z - 1); ++z)
    for (int y = max(at.y - 1, 0); grows && y <= min(at.y + 1, n.y - 1); ++y)
      for (int x = max(at.x - 1, 0); grows && x <= min(at.x + 1, n.x - 1); ++x)
        grows = from[(z * n.y + y) * n.x + x] >= ring;
  reach[n.w + cell] = grows ? (uchar)(ring + 1u) : own;
}
