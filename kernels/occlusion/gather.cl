// SPDX-License-Identifier: Apache-2.0
// Density of the spheres -> what of the surroundings is seen from each cell, as a mean over directions and a trend.
#include "common/inline.clh"
#include "shared/occlusion_data.h"

/// Optical depth beyond which nothing is seen.
#define CDSM_OCCLUSION_END 6.0f

/// Linear between the middles of a level's cells; `p`: in cells of that level, with its border.
CDSM_INLINE float density(__global const uint* cells, int4 level, float3 p) {
  p = clamp(p - 0.5f, (float3)(0.0f), convert_float3(level.xyz) - 1.001f);
  int3 i = convert_int3(p);
  float3 f = p - convert_float3(i);
  uint row = (uint)level.x, slice = row * (uint)level.y;
  __global const uint* c = cells + (uint)level.w + ((uint)i.z * slice + (uint)i.y * row + (uint)i.x);
  float4 near = (float4)((float)c[0], (float)c[row], (float)c[slice], (float)c[slice + row]);
  float4 far = (float4)((float)c[1], (float)c[row + 1], (float)c[slice + 1], (float)c[slice + row + 1]);
  float4 x = mix(near, far, f.x);
  float2 y = mix(x.xz, x.yw, f.y);
  return mix(y.x, y.y, f.z);
}

/// Transparency of a cone from a point, in cells, along a direction: cells get larger as it gets wider.
CDSM_INLINE float coneTransparency(const OcclusionParams* params, __global const uint* cells, float3 p, float4 dir) {
  float depth = 0.0f;
  for (uint k = 0; k < params->stepCount && depth < CDSM_OCCLUSION_END; ++k) {
    float4 step = params->steps[k];
    int level = (int)step.z;
    float3 at = (p + dir.w * step.x * dir.xyz) / (float)(1 << level) + 1.0f;
    depth += step.y * density(cells, params->levels[level], at);
  }
  return exp(-dir.w * depth);
}

/// Least and greatest density in the cells of the second level around one.
uint2 densitiesAround(const OcclusionParams* params, __global const uint* cells, int3 cell) {
  int4 level = params->levels[1];
  int3 middle = cell / 2 + 1;
  uint2 around = (uint2)(CDSM_OCCLUSION_MOST, 0);
  for (int k = 0; k < 27; ++k) {
    int3 at = clamp(middle + (int3)(k % 3, k / 3 % 3, k / 9) - 1, (int3)(0), level.xyz - 1);
    uint here = cells[level.w + (at.z * level.y + at.y) * level.x + at.x];
    around = (uint2)(min(around.x, here), max(around.y, here));
  }
  return around;
}

/// In place of what is seen: nothing is looked up in this cell.
#define CDSM_UNSEEN (short4)(-1, 0, 0, 0)

CDSM_INLINE int3 cellOfNumber(uint number, int4 size) {
  uint width = (uint)size.x, height = (uint)size.y;
  return (int3)((int)(number % width), (int)(number / width % height), (int)(number / width / height));
}

/// A work item per cell from params.firstCell on. directions: eight sets, one for each of 2 x 2 x 2 cells, in turn.
/// seen: x: mean transparency over the directions, y, z, w: slope of what a cosine-weighted hemisphere around a unit
/// vector sees [Ramamoorthi & Hanrahan 2001, the first two bands]; 1 is 32767.
__kernel void gatherOcclusion(OcclusionParams params, __global const float4* directions, __global const uint* cells,
                              __global short4* seen) {
  uint number = params.firstCell + (uint)get_global_id(0);
  if (number >= params.lastCell) return;
  int3 cell = cellOfNumber(number, params.grid.size);
  uint2 around = densitiesAround(&params, cells, cell);
  bool buried = around.x >= params.buried;
  if (around.y == 0 || buried) {
    seen[number] = buried ? (short4)(0) : CDSM_UNSEEN;
    return;
  }
  uint count = params.directionCount, set = (uint)((cell.x & 1) | (cell.y & 1) << 1 | (cell.z & 1) << 2);
  float3 middle = convert_float3(cell) + 0.5f, slope = (float3)(0.0f), directionSum = (float3)(0.0f);
  float sum = 0.0f;
  for (uint i = 0; i < count; ++i) {
    float4 dir = directions[set * count + i];
    float t = coneTransparency(&params, cells, middle, dir);
    sum += t;
    slope += t * dir.xyz;
    directionSum += dir.xyz;
  }
  float mean = sum / (float)count;
  slope = (slope - mean * directionSum) * (2.0f / (float)count);
  seen[number] = convert_short4_sat_rte((float4)(mean, slope) * 32767.0f);
}

/// What a cell that is full of spheres weighs against an empty one.
#define CDSM_FULL_WEIGHT 0.001f

/// A work item per cell from params.firstCell on: the mean of 3 x 3 x 3 cells that weigh 1 : 2 : 1 along each axis,
/// which joins the eight sets of directions, and the more the emptier they are: surfaces see what is in front of them.
__kernel void smoothOcclusion(OcclusionParams params, __global const uint* cells, __global const short4* rough,
                              __global short4* seen) {
  uint number = params.firstCell + (uint)get_global_id(0);
  if (number >= params.lastCell) return;
  int4 size = params.grid.size, level = params.levels[0];
  int3 cell = cellOfNumber(number, size);
  float4 sum = (float4)(0.0f);
  float weights = 0.0f;
  for (int k = 0; k < 27; ++k) {
    int3 step = (int3)(k % 3, k / 3 % 3, k / 9) - 1, at = cell + step;
    if (any(at < 0) || any(at >= size.xyz)) continue;
    short4 there = rough[(at.z * size.y + at.y) * size.x + at.x];
    if (there.x < 0) continue;
    float depth = (float)cells[level.w + ((at.z + 1) * level.y + at.y + 1) * level.x + at.x + 1] / CDSM_OCCLUSION_ONE;
    float weight = max(1.0f - depth, CDSM_FULL_WEIGHT) * (float)(8 >> (abs(step.x) + abs(step.y) + abs(step.z)));
    sum += weight * convert_float4(there);
    weights += weight;
  }
  bool unseen = rough[number].x < 0;
  seen[number] = unseen ? (short4)(32767, 0, 0, 0) : convert_short4_sat_rte(sum / weights);
}
