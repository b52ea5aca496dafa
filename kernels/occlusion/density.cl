// SPDX-License-Identifier: Apache-2.0
// Spheres -> how dense they are in each cell of a grid, and in ever larger cells [Krone 2017, §4, after Staib 2015].
#include "common/sphere.clh"
#include "shared/occlusion_data.h"

/// Number of a cell of a level that has a border.
CDSM_INLINE size_t borderedCell(int4 level, int x, int y, int z) {
  return (size_t)level.w + ((size_t)(z + 1) * (size_t)level.y + (size_t)(y + 1)) * (size_t)level.x + (size_t)(x + 1);
}

/// Adds up to the most that a cell holds: whatever the order, the sum is the same.
void addDensity(volatile __global uint* cell, uint amount) {
  uint before = 0, seen = atomic_cmpxchg(cell, before, min(amount, CDSM_OCCLUSION_MOST));
  while (seen != before && seen < CDSM_OCCLUSION_MOST) {
    before = seen;
    seen = atomic_cmpxchg(cell, before, min(before + amount, CDSM_OCCLUSION_MOST));
  }
}

/// How a sphere covers cells around it; lengths in cells.
typedef struct Splat {
  float3 center;
  float radius;  // at least half a cell: smaller ones are spread over that
  float depth;   // optical depth across a cell that it covers
} Splat;

/// Rays that meet spheres strewn at random are stopped as by 3/4 of their share of the space over the radius. Where a
/// sphere is as large as a cell, twice that: hardly any of them gets through its middle.
Splat splatOf(float4 sphere, OcclusionGrid grid, float opacity) {
  float radius = sphere.w / grid.corner.w;
  Splat s;
  s.center = (sphere.xyz - grid.corner.xyz) / grid.corner.w;
  s.radius = max(radius, 0.5f);
  // the share of covered cells, which fade out within half a cell on both sides of the surface, adds up to the volume
  float share = radius * radius * radius / (s.radius * (s.radius * s.radius + 0.25f));
  s.depth = opacity * share * 0.75f * (1.0f + min(2.0f * radius, 1.0f)) / min(radius, 1.0f);
  return s;
}

/// Adds a slice of cells of one z.
void splatSlice(const Splat* s, int z, int4 level, int4 size, __global uint* cells) {
  int2 first = max(convert_int2_rtn(s->center.xy - s->radius - 0.5f), (int2)(0));
  int2 last = min(convert_int2_rtn(s->center.xy + s->radius + 0.5f), size.xy - 1);
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) {
      float away = length((float3)(x + 0.5f, y + 0.5f, z + 0.5f) - s->center);
      float covered = clamp(0.5f - (away - s->radius), 0.0f, 1.0f);
      uint amount = convert_uint_sat_rte(covered * s->depth * CDSM_OCCLUSION_ONE);
      if (amount > 0) addDensity(&cells[borderedCell(level, x, y, z)], amount);
    }
}

/// A work item per sphere and slice: params.slices items of a sphere take its cells by their z in turn. `level`: the
/// first one; cells must be 0 before.
__kernel void addSpheres(DensityParams params, int4 level, __global const SceneSphere* spheres,
                         __global const ObjectData* objects, __global uint* cells) {
  if (get_global_id(0) >= params.count) return;
  __global const SceneSphere* sphere = &spheres[params.first + (uint)get_global_id(0)];
  __global const ObjectData* object = &objects[as_uint(sphere->color.w)];
  if (!object->casts) return;
  float clear = 1.0f - object->diffuse.w;  // of one of the two crossings
  Splat s = splatOf(worldSphere(sphere, objects), params.grid, 1.0f - clear * clear);
  int first = max((int)floor(s.center.z - s.radius - 0.5f), 0);
  int last = min((int)floor(s.center.z + s.radius + 0.5f), params.grid.size.z - 1);
  for (int z = first + (int)get_global_id(1); z <= last; z += (int)params.slices)
    splatSlice(&s, z, level, params.grid.size, cells);
}

/// 1 : 3 : 3 : 1 along an axis, in eighths.
CDSM_INLINE uint joinWeight(int i) { return i == 0 || i == 3 ? 1u : 3u; }

/// A work item per cell of a level, its border left out: the mean of 4 x 4 x 4 of the level below that weigh 1, 3, 3, 1
/// along each axis: means of 2 x 2 x 2 alone would be seen as blocks.
__kernel void joinCells(int4 below, int4 level, __global uint* cells) {
  int width = level.x - 2, height = level.y - 2;
  int i = (int)get_global_id(0);
  if (i >= width * height * (level.z - 2)) return;
  int x = i % width, y = i / width % height, z = i / width / height;
  ulong sum = 0;
  for (int k = 0; k < 64; ++k) {
    int3 step = (int3)(k & 3, k >> 2 & 3, k >> 4), at = 2 * (int3)(x, y, z) + step - 1;
    if (any(at < 0) || any(at >= below.xyz - 2)) continue;
    uint weight = joinWeight(step.x) * joinWeight(step.y) * joinWeight(step.z);
    sum += (ulong)weight * cells[borderedCell(below, at.x, at.y, at.z)];
  }
  cells[borderedCell(level, x, y, z)] = (uint)(sum / 512u);
}
