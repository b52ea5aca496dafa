// SPDX-License-Identifier: Apache-2.0
// Transmittance from one light to given points: the engine without its renderer [INTERFACE, 4.6].
#include "device/lookup.clh"

/// A work item per point (three floats each). values: transmittance, -1 where the point is not lit.
__kernel void queryPoints(QueryParams params, __global const float* points, __global float* values,
                          CDSM_LOOKUP_PARAMS) {
  uint i = (uint)get_global_id(0);
  if (i >= params.pointCount) return;
  float3 p = vload3(0, points + (ulong)i * params.pointStride);
  values[i] = cdsmLit(params.light, p, CDSM_LOOKUP_ARGS) ? cdsmTransmittance(params.light, p, CDSM_LOOKUP_ARGS) : -1.0f;
}
