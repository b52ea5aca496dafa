// SPDX-License-Identifier: Apache-2.0
// Transmittance from one light to given points: the engine without its renderer [INTERFACE, 4.6].
#include "common/medium.clh"
#include CDSM_CACHE
#include "shared/frame_data.h"

/// A work item per point (three floats each). values: transmittance, -1 where the point is not lit.
__kernel void queryPoints(QueryParams params, __global const float* points, __global float* values,
                          __global const LightData* lights, CDSM_LIGHT_PARAMS, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint i = (uint)get_global_id(0);
  if (i >= params.pointCount) return;
  float3 p = vload3(i, points);
  __global const LightData* light = &lights[params.light];
  values[i] = litPoint(light, p)
                  ? lightOnPoint(light, p, scene, CDSM_LIGHT_ARGS CDSM_VOLUME_ARGS)
                  : -1.0f;
}
