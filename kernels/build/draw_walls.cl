// SPDX-License-Identifier: Apache-2.0
// Some of the spheres of a view that nothing gets past -> per pixel the depth of the nearest of them, per tile the
// farthest of its pixels'; these walls -> which spheres they hide.
#include "build/sphere_walls.clh"

/// Pixels that an outline made by another kernel may differ by: a wall is only where that surely has the pixel.
#define CDSM_WALL_MARGIN 0.05f

/// A work item per sphere: every params.stride-th one from params.first on. depths: bits of floats, which are positive
/// and order as they do; the least wins, whatever the order.
__kernel void drawWalls(WallParams params, ViewData view, __global const SceneSphere* spheres,
                        __global const ObjectData* objects, __global const float* walls,
                        volatile __global uint* depths) {
  if (get_global_id(0) >= params.count) return;
  __global const SceneSphere* sphere = &spheres[params.first + params.stride * (uint)get_global_id(0)];
  if (!objects[as_uint(sphere->color.w)].hides) return;
  float4 world = worldSphere(sphere, objects);
  float depth = dot(view.depth.xyz, world.xyz) + view.depth.w;
  PixelBox box = pixelsAround(&view, world.xyz, world.w);
  if (depth - world.w < view.nearDepth || !box.known || isLargeBox(box)) return;
  if (isBehindTiles(&view, box, nearestDepth(depth, world.w), walls)) return;
  float radius = world.w - CDSM_WALL_MARGIN * pixelWidth(&view, depth);
  if (radius <= 0.0f) return;
  for (int y = box.y0; y <= box.y1; ++y)
    for (int x = box.x0; x <= box.x1; ++x) {
      Ray ray = rayThroughPixel(&view, x + 0.5f, y + 0.5f);
      SphereCrossings c = crossSphere(world.xyz - ray.origin, radius, ray.dir);
      if (c.hit && c.enter >= view.nearDepth) atomic_min(&depths[y * view.width + x], as_uint(c.enter));
    }
}

/// A work item per sphere, params.count from params.first on: 1 where walls of tiles hide it.
__kernel void hideSpheres(SetupParams params, ViewData view, __global const SceneSphere* spheres,
                          __global const ObjectData* objects, __global const float* walls, __global uchar* hidden) {
  if (get_global_id(0) >= params.count) return;
  uint id = params.first + (uint)get_global_id(0);
  float4 sphere = worldSphere(&spheres[id], objects);
  float depth = dot(view.depth.xyz, sphere.xyz) + view.depth.w;
  float radius = max(sphere.w, params.leastRadius * pixelWidth(&view, depth));
  PixelBox box = pixelsAround(&view, sphere.xyz, radius);
  hidden[id] = isBehindTiles(&view, box, nearestDepth(depth, radius), walls) ? 1 : 0;
}

/// A work item per tile.
__kernel void raiseWalls(ViewData view, __global const uint* depths, __global float* walls) {
  int tile = (int)get_global_id(0);
  if (tile >= view.tilesX * view.tilesY) return;
  int x0 = tile % view.tilesX * CDSM_TILE, y0 = tile / view.tilesX * CDSM_TILE;
  uint farthest = 0;
  for (int y = y0; y < min(y0 + CDSM_TILE, view.height); ++y)
    for (int x = x0; x < min(x0 + CDSM_TILE, view.width); ++x) farthest = max(farthest, depths[y * view.width + x]);
  walls[tile] = as_float(farthest);
}
