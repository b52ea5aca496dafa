// SPDX-License-Identifier: Apache-2.0
// Fills a shadow volume: transmittance from one light at the voxel centres of one volume [Ropinski 2008, §3.1].
#include "cache/shadow_voxels.clh"
#include "common/medium.clh"
#include CDSM_TECHNIQUE
#include "shared/frame_data.h"

/// The macrocell along one axis that a voxel coordinate is in.
CDSM_INLINE int cellAt(int voxel, int cells) { return clamp(voxel / CDSM_MACROCELL, 0, cells - 1); }

/// True where a sample that has an extinction may interpolate the voxel: it is in a macrocell that is not empty, or beside
/// one.
bool isInterpolated(__global const MediumData* m, __global const uchar* cells, int3 voxel) {
  int4 n = m->cells;
  for (int corner = 0; corner < 8; ++corner) {
    int x = cellAt(voxel.x + ((corner & 1) ? 1 : -1), n.x), y = cellAt(voxel.y + ((corner & 2) ? 1 : -1), n.y);
    int z = cellAt(voxel.z + ((corner & 4) ? 1 : -1), n.z);
    if (cells[n.w + (z * n.y + y) * n.x + x] == 0) return true;
  }
  return false;
}

/// A work item per voxel, from params.firstVoxel on. Voxels that nobody interpolates stay as they are.
__kernel void fillShadowVolume(FillParams params, __global ushort* shadowVoxels, __global const LightData* lights,
                               CDSM_TECHNIQUE_PARAMS, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint voxel = params.firstVoxel + (uint)get_global_id(0);
  if (voxel >= params.lastVoxel) return;
  __global const MediumData* m = &media[params.medium];
  __global const LightData* light = &lights[params.light];
  uint width = (uint)m->size.x, height = (uint)m->size.y;
  int3 index = (int3)((int)(voxel % width), (int)(voxel / width % height), (int)(voxel / width / height));
  if (!isInterpolated(m, cells, index)) return;
  Spectrum t = lightTransmittancePoint(light, transformPoint(params.worldFromIndex, convert_float3(index)), scene,
                                       CDSM_TECHNIQUE_ARGS CDSM_VOLUME_ARGS);
  float channels[CDSM_CHANNELS];
  splitSpectrum(t, channels);
  for (int c = 0; c < CDSM_CHANNELS; ++c)
    shadowVoxels[firstShadowVoxel(light, m->firstShadowBlock, m->size, c) + voxel] =
        convert_ushort_sat_rte(channels[c] * CDSM_SHADOW_ONE);
}
