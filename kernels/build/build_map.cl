// SPDX-License-Identifier: Apache-2.0
// Sorted fragments of a light's view -> one compressed visibility function per texel, handed to the memory strategy
// [Knecht 2011, §3.2, Alg. 3.1]. CDSM_MARCH: how a ray goes through media, LightRay, beginMarch() and marchSegment().
#include CDSM_MARCH

/// The visibility function of texel (x, y), from its fragments to its nodes.
CDSM_INLINE void buildTexel(const BuildParams* params, int x, int y, uint2 range, __global ulong* fragments,
                            __global const uint* initialObjects, NodeWriter* writer, DepthScale scale,
                            SceneAccess scene CDSM_MARCH_PARAMS CDSM_VOLUME_PARAMS) {
  LightRay r;
  r.ray = rayThroughPixel(&params->view, x + 0.5f, y + 0.5f);
  r.builder = beginVisibility(writer, scale);
  r.transmittance = (Spectrum)(1.0f);

  SegmentWalk walk = beginWalk(fragments, range, &params->view, initialObjects, scene);
  beginMarch(&r, &walk, params->tolerance);
  while (walk.left > 0 && anyChannel(r.transmittance > 0.0f)) {
    float depth = nextDepth(&walk);
    if (walk.mediumCount > 0 && depth > walk.depth)
      marchSegment(&r, scene, &walk, depth, params->interiorStep CDSM_MARCH_ARGS CDSM_VOLUME_ARGS);
    Spectrum through = throughSurface(&scene.objects[surfaceObject(scene, nextFacing(&walk))]);
    if (anyChannel(through < 1.0f) && anyChannel(r.transmittance > 0.0f)) {
      r.transmittance = visiblePart(r.transmittance * through, r.least);
      dropAt(&r.builder, depth, r.transmittance);
    }
    passFragment(&walk, scene);
  }
  finishVisibility(&r.builder);
  *writer = r.builder.writer;
}

/// A group per tile, an item per texel. Items outside of the map have nothing to build, but meet the others of their
/// group where the memory strategy lets them wait for each other.
__kernel void buildVisibility(BuildParams params, __global ulong* fragments, __global const uint2* ranges,
                              __global const MapData* maps, CDSM_MEMORY_WRITE_PARAMS,
                              CDSM_SCENE_PARAMS CDSM_MARCH_PARAMS CDSM_TILE_DEPTHS_WRITE_PARAM) {
  CDSM_SCENE_ACCESS(scene);
  __local TileMemory shared;
  __local TileSpan span;
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  int x = (int)(tile % (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  uint2 range = ranges[tile * CDSM_TILE_PIXELS + pixel];
  if (x >= params.view.width || y >= params.view.height) range.y = 0;
  MapData map = maps[params.mapIndex];
  float2 reach = raySpan(fragments, range, &params.view);
  DepthScale scale = beginDepths(&map, tile, pixel, reach.x, reach.y, &span CDSM_TILE_DEPTHS_ARG);
  bool wanted = beginTile(tile, pixel, &shared, CDSM_MEMORY_WRITE_ARGS);
  if (wanted && x < params.view.width && y < params.view.height) {
    NodeWriter writer = beginNodes(&map, x, y, &shared, CDSM_MEMORY_WRITE_ARGS);
    buildTexel(&params, x, y, range, fragments, initialObjects, &writer, scale, scene CDSM_MARCH_ARGS CDSM_VOLUME_ARGS);
    endNodes(&writer);
  }
  endTile(tile, pixel, &shared, CDSM_MEMORY_WRITE_ARGS);
}
