// SPDX-License-Identifier: Apache-2.0
// Least and greatest voxel of each macrocell; a cell covers its 8 voxels per axis and the next one, which its samples
// interpolate too. CDSM_VOXEL is the voxel type.
#include "shared/scene_data.h"

/// A work item per cell.
__kernel void cellBounds(int4 size, int4 cells, __global const CDSM_VOXEL* voxels, __global float2* bounds) {
  int cell = (int)get_global_id(0);
  if (cell >= cells.x * cells.y * cells.z) return;
  int x0 = cell % cells.x * CDSM_MACROCELL, y0 = cell / cells.x % cells.y * CDSM_MACROCELL;
  int z0 = cell / (cells.x * cells.y) * CDSM_MACROCELL;
  int x1 = min(x0 + CDSM_MACROCELL, size.x - 1), y1 = min(y0 + CDSM_MACROCELL, size.y - 1);
  int z1 = min(z0 + CDSM_MACROCELL, size.z - 1);
  float low = INFINITY, high = -INFINITY;
  for (int z = z0; z <= z1; ++z)
    for (int y = y0; y <= y1; ++y) {
      __global const CDSM_VOXEL* row = voxels + ((uint)z * (uint)size.y + (uint)y) * (uint)size.x;
      for (int x = x0; x <= x1; ++x) {
        float value = (float)row[x];
        low = min(low, value);
        high = max(high, value);
      }
    }
  bounds[cell] = (float2)(low, high);
}
