// SPDX-License-Identifier: Apache-2.0
// Sorted fragments of a light's view -> per texel where its light is stopped. CDSM_STOP: by what, LightStop with its
// depth or depths, beginStop(), stopInSegment(), stopAtSurface(), isStopped() and storeStop().
#include CDSM_STOP

/// A group per tile, an item per texel.
__kernel void buildDepths(DepthParams params, __global ulong* fragments, __global const uint2* ranges,
                          __global float* depths, CDSM_SCENE_PARAMS CDSM_STOP_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  int x = (int)(tile % (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  if (x >= params.view.width || y >= params.view.height) return;

  Ray ray = rayThroughPixel(&params.view, x + 0.5f, y + 0.5f);
  SegmentWalk walk = beginWalk(fragments, ranges[tile * CDSM_TILE_PIXELS + pixel], &params.view, initialObjects,
                               scene);
  LightStop stop;
  stop.depth = INFINITY;
  if (walk.left > 0) beginStop(&stop, &params, x, y);
  while (walk.left > 0 && !isStopped(&stop)) {
    float depth = nextDepth(&walk);
    if (walk.mediumCount > 0 && depth > walk.depth)
      stopInSegment(&stop, &ray, &walk, depth, scene CDSM_STOP_ARGS CDSM_VOLUME_ARGS);
    uint facing = nextFacing(&walk);
    if (!isStopped(&stop)) stopAtSurface(&stop, depth, &scene.objects[surfaceObject(scene, facing)], facing);
    passFragment(&walk, scene);
  }
  storeStop(&stop, params.firstTexel + (uint)y * (uint)params.view.width + (uint)x, scene, depths);
}
