// SPDX-License-Identifier: Apache-2.0
// Transmittance from one light to given points: the engine without its renderer [INTERFACE, 4.6].
#include "device/lookup.clh"

/// A work item per point (three floats each). values: transmittance, CDSM_CHANNELS floats each, -1 where the point is
/// not lit.
__kernel void queryPoints(QueryParams params, __global const float* points, __global float* values,
                          CDSM_LOOKUP_PARAMS) {
  uint i = (uint)get_global_id(0);
  if (i >= params.pointCount) return;
  float3 p = vload3(0, points + (ulong)i * params.pointStride);
  bool lit = cdsmLit(params.light, p, CDSM_LOOKUP_ARGS);
  storeResult(lit ? cdsmTransmittance(params.light, p, CDSM_LOOKUP_ARGS) : (Spectrum)(-1.0f), i, values);
}
