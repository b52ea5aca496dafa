// SPDX-License-Identifier: Apache-2.0
// Sorted fragments of a light's view -> per texel the depth of what stops the light, all or nothing: the first surface or
// sample that is more opaque than the threshold [Ropinski 2008, §3.2].
#include "common/medium.clh"
#include "common/segments.clh"
#include "shared/frame_data.h"

/// Depth of the first sample of a volume with an extinction over `limit`; infinite without one.
CDSM_INLINE float volumeHit(const Ray* ray, const Steps* steps, float limit, SceneAccess scene,
                            const MediumData* m CDSM_VOLUME_PARAMS) {
  IndexRay index = indexRay(m, ray);
  for (int i = 0; i < steps->count;) {
    Run run = volumeRun(m, scene.cells, &index, steps, i);
    for (; i < run.end && !run.empty; i += CDSM_BATCH) {
      floatN extinctions = sampleExtinctions(scene, m, &index, steps, i CDSM_VOLUME_ARGS);
      if (!any(extinctions > limit)) continue;
      float values[CDSM_BATCH];
      vstoreN(extinctions, 0, values);
      for (int k = 0; k < CDSM_BATCH && i + k < run.end; ++k)
        if (values[k] > limit) return sampleDepth(steps, i + k);
    }
    i = run.end;
  }
  return INFINITY;
}

/// Where a segment that ends at depth `end` stops the light; infinite if it does not. What fills a mesh does so at once.
float segmentHit(const Ray* ray, const SegmentWalk* walk, float end, __global const float* opaqueExtinctions,
                 SceneAccess scene CDSM_VOLUME_PARAMS) {
  Steps steps = stepsOf(walk->depth, end, segmentStep(walk, scene, INFINITY), ray);
  float hit = INFINITY;
  for (uint k = 0; k < walk->mediumCount; ++k) {
    uint medium = activeMedium(walk, scene, k);
    MediumData m = scene.media[medium];
    float limit = opaqueExtinctions[medium];
    if (m.size.w >= 0)
      hit = min(hit, volumeHit(ray, &steps, limit, scene, &m CDSM_VOLUME_ARGS));
    else if (m.interior.w > limit)
      return walk->depth;
  }
  return hit;
}

/// A group per tile, an item per texel. opaqueExtinctions: per medium. depths[texel]: infinite where nothing stops the
/// light.
__kernel void buildDepths(DepthParams params, __global ulong* fragments, __global const uint2* ranges,
                          __global const float* opaqueExtinctions, __global float* depths, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  int x = (int)(tile % (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  if (x >= params.view.width || y >= params.view.height) return;

  Ray ray = rayThroughPixel(&params.view, x + 0.5f, y + 0.5f);
  SegmentWalk walk = beginWalk(fragments, ranges[tile * CDSM_TILE_PIXELS + pixel], &params.view, initialObjects,
                               scene);
  float hit = INFINITY;
  while (walk.left > 0 && isinf(hit)) {
    float depth = nextDepth(&walk);
    if (walk.mediumCount > 0 && depth > walk.depth)
      hit = segmentHit(&ray, &walk, depth, opaqueExtinctions, scene CDSM_VOLUME_ARGS);
    float opacity = scene.objects[surfaceObject(scene, nextFacing(&walk))].diffuse.w;
    if (isinf(hit) && opacity > params.threshold) hit = depth;
    passFragment(&walk, scene);
  }
  depths[params.firstTexel + (uint)y * (uint)params.view.width + (uint)x] = hit;
}
