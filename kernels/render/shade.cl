// SPDX-License-Identifier: Apache-2.0
// Sorted fragments of the camera's view -> image: surfaces and media shaded by every light, front to back
// [Knecht 2011, §3.3, Alg. 3.3, eqs. 3.9-3.11].
#include "render/shade_media.clh"
#include "render/shade_surface.clh"

/// A group per tile, an item per pixel. seen: of ambient occlusion; image: rgba, row after row; samples[pixel]: volume
/// samples shaded.
__kernel void shadePixels(ShadeParams params, __global ulong* fragments, __global const uint2* ranges,
                          __global const LightData* lights, __global const short4* seen, __global float4* image,
                          __global uint* samples, CDSM_LIGHT_PARAMS, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  int x = (int)(tile % (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  if (x >= params.view.width || y >= params.view.height) return;

  CameraRay r;
  r.ray = rayThroughPixel(&params.view, x + 0.5f, y + 0.5f);
  r.color = (float3)(0.0f);
  r.transparency = 1.0f;
  r.samples = 0;
  for (int i = 0; i < CDSM_TRACKS; ++i) r.tracks[i].valid = false;
  SegmentWalk walk = beginWalk(fragments, ranges[tile * CDSM_TILE_PIXELS + pixel], &params.view, initialObjects,
                               scene);
  while (walk.left > 0 && r.transparency > CDSM_OPAQUE) {
    float depth = nextDepth(&walk);
    if (walk.mediumCount > 0 && depth > walk.depth)
      shadeSegment(&r, scene, &walk, depth, &params, lights, CDSM_LIGHT_ARGS CDSM_VOLUME_ARGS);
    if (r.transparency > CDSM_OPAQUE)
      shadeSurface(&r, scene, nextFacing(&walk), depth, &params, seen, lights, CDSM_LIGHT_ARGS CDSM_VOLUME_ARGS);
    passFragment(&walk, scene);
  }
  if (r.transparency <= CDSM_OPAQUE) r.transparency = 0.0f;
  size_t at = (size_t)y * (size_t)params.view.width + (size_t)x;
  image[at] = (float4)(r.color, 1.0f - r.transparency);
  samples[at] = r.samples;
}
