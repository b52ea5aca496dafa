// SPDX-License-Identifier: Apache-2.0
// Fills a shadow volume: transmittance from one light at the voxel centres of one volume [Ropinski 2008, §3.1].
#include "common/medium.clh"
#include CDSM_TECHNIQUE
#include "shared/frame_data.h"

/// A work item per voxel, from params.firstVoxel on.
__kernel void fillShadowVolume(FillParams params, __global ushort* shadowVoxels, __global const LightData* lights,
                               CDSM_TECHNIQUE_PARAMS, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint voxel = params.firstVoxel + (uint)get_global_id(0);
  uint width = (uint)params.size.x, height = (uint)params.size.y;
  if (voxel >= params.lastVoxel) return;
  float3 index = (float3)((float)(voxel % width), (float)(voxel / width % height), (float)(voxel / width / height));
  float t = lightTransmittancePoint(&lights[params.light], transformPoint(params.worldFromIndex, index), scene,
                                    CDSM_TECHNIQUE_ARGS CDSM_VOLUME_ARGS);
  shadowVoxels[(size_t)params.firstBlock * CDSM_SHADOW_BLOCK + voxel] = convert_ushort_sat_rte(t * CDSM_SHADOW_ONE);
}
