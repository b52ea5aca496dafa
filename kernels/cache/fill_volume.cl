// SPDX-License-Identifier: Apache-2.0
// Fills a shadow volume: transmittance from one light at the voxel centres of one volume [Ropinski 2008, §3.1].
#include "cache/shadow_voxels.clh"
#include "common/medium.clh"
#include CDSM_TECHNIQUE
#include "shared/frame_data.h"

/// Bit k is set if the macrocell is not empty that lies (k & 1, k >> 1 & 1, k >> 2) before cell (x, y, z).
CDSM_INLINE uint filledCells(int4 n, __global const uchar* cells, int x, int y, int z) {
  uint filled = 0;
  for (int k = 0; k < 8; ++k) {
    int row = max(z - (k >> 2), 0) * n.y + max(y - (k >> 1 & 1), 0);
    if (cells[n.w + row * n.x + max(x - (k & 1), 0)] == 0) filled |= 1u << k;
  }
  return filled;
}

/// A group per macrocell, from params.firstCell on, an item per row of its voxels along x. Samples of a cell
/// interpolate its own voxels and the first ones of the cells behind it; voxels that nobody interpolates stay.
__kernel void fillShadowVolume(FillParams params, __global ushort* shadowVoxels, __global const LightData* lights,
                               CDSM_TECHNIQUE_PARAMS, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  __global const MediumData* m = &media[params.medium];
  __global const LightData* light = &lights[params.light];
  int4 n = m->cells, size = m->size;
  int cell = (int)(params.firstCell + (uint)get_group_id(0)), row = (int)get_local_id(0);
  int cellX = cell % n.x, cellY = cell / n.x % n.y, cellZ = cell / n.x / n.y;
  int restY = row % CDSM_MACROCELL, restZ = row / CDSM_MACROCELL;
  uint filled = filledCells(n, cells, cellX, cellY, cellZ) & (restY > 0 ? 0x33u : 0xffu) & (restZ > 0 ? 0x0fu : 0xffu);
  int x = cellX * CDSM_MACROCELL, y = cellY * CDSM_MACROCELL + restY, z = cellZ * CDSM_MACROCELL + restZ;
  if (filled == 0 || y >= size.y || z >= size.z) return;
  // voxels behind the first one belong to this column of cells alone
  int end = (filled & 0x55u) != 0 ? min(x + CDSM_MACROCELL, size.x) : x + 1;
  size_t first = ((size_t)z * (size_t)size.y + (size_t)y) * (size_t)size.x;
  for (; x < end; ++x) {
    float3 center = transformPoint(params.worldFromIndex, (float3)((float)x, (float)y, (float)z));
    Spectrum t = lightTransmittancePoint(light, center, scene, CDSM_TECHNIQUE_ARGS CDSM_VOLUME_ARGS);
    storeShadow(t, light, m, first + (size_t)x, shadowVoxels);
  }
}
