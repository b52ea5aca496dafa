// SPDX-License-Identifier: Apache-2.0
// Spheres of the scene -> spheres on the screen with their exact outlines. The rays of pixels (u, v) meet a sphere
// where a quadratic of u and v says so: the distance of the ray from the centre, times the length of the ray's
// direction, is at most the radius times that length. Around the centre's own pixel nothing in it cancels.
#include "build/sphere_walls.clh"

/// a x^2 + 2 b x y + c y^2 + 2 d x + 2 e y + f <= 0: pixels (x, y) from the centre's that meet the sphere.
typedef struct Conic {
  float a, b, c, d, e, f;
} Conic;

/// Depth over radius from which on the conic is an ellipse that rounding does not touch.
#define CDSM_ELLIPSE_DEPTH 1.05f
/// Pixels that rounding may move an outline by.
#define CDSM_OUTLINE_SLACK 0.01f

/// One pixel to the side at the centre's depth is `u` or `v` in the world; views turn rays or move them, not both.
Conic conicOf(const ViewData* view, float2 pixel, float depth, float radius) {
  float3 dir = view->dir.xyz + pixel.x * view->dirU.xyz + pixel.y * view->dirV.xyz;
  float3 u = cross(view->originU.xyz + depth * view->dirU.xyz, dir);
  float3 v = cross(view->originV.xyz + depth * view->dirV.xyz, dir);
  float3 turnU = radius * view->dirU.xyz, turnV = radius * view->dirV.xyz;
  Conic q;
  q.a = dot(u, u) - dot(turnU, turnU);
  q.b = dot(u, v) - dot(turnU, turnV);
  q.c = dot(v, v) - dot(turnV, turnV);
  q.d = -radius * dot(turnU, dir);
  q.e = -radius * dot(turnV, dir);
  q.f = -radius * radius * dot(dir, dir);
  return q;
}

/// Rows of an ellipse, x, y, z: their half widths as ScreenSphere::reach, and its lowest and highest row.
typedef struct Rows {
  float3 reach;
  float low, high;
} Rows;

Rows rowsOf(Conic q) {
  float b = q.b / q.a, d = q.d / q.a;
  Rows rows;
  rows.reach = (float3)(q.c / q.a - b * b, q.e / q.a - b * d, d * d - q.f / q.a);
  float root = sqrt(max(rows.reach.y * rows.reach.y + rows.reach.x * rows.reach.z, 0.0f));
  rows.low = (-rows.reach.y - root) / rows.reach.x;
  rows.high = (-rows.reach.y + root) / rows.reach.x;
  return rows;
}

Conic transposed(Conic q) {
  Conic t = {q.c, q.b, q.a, q.e, q.d, q.f};
  return t;
}

/// First and last pixel of [low, high] in a view of this width, or (1, 0).
int2 pixelsBetween(float low, float high, int width) {
  float first = ceil(low - 0.5f - CDSM_OUTLINE_SLACK), last = floor(high - 0.5f + CDSM_OUTLINE_SLACK);
  if (!(first <= last) || last < 0.0f || first >= (float)width) return (int2)(1, 0);
  return (int2)((int)max(first, 0.0f), (int)min(last, (float)(width - 1)));
}

/// Fills in the outline of a sphere of this radius; pixels of the box around it, empty if z < x or w < y.
int4 outlineSphere(ScreenSphere* s, const ViewData* view, float3 center, float depth, float radius) {
  float w = dot(view->pixelW.xyz, center) + view->pixelW.w;
  float2 pixel = (float2)(dot(view->pixelU.xyz, center) + view->pixelU.w,
                          dot(view->pixelV.xyz, center) + view->pixelV.w) / w;
  Conic q = conicOf(view, pixel, depth, radius);
  Rows rows = rowsOf(q), columns = rowsOf(transposed(q));
  s->outline = (float4)(pixel, q.b / q.a, q.d / q.a);
  s->reach = (float4)(rows.reach, 1.0f);
  int2 x = pixelsBetween(pixel.x + columns.low, pixel.x + columns.high, view->width);
  int2 y = pixelsBetween(pixel.y + rows.low, pixel.y + rows.high, view->height);
  return (int4)(x.x, y.x, x.y, y.y);
}

/// True if all of a sphere lies on the outer side of a plane.
bool beyond(float4 plane, float3 center, float radius) {
  return dot(plane.xyz, center) + plane.w < -radius * length(plane.xyz);
}

bool besideView(const ViewData* view, float3 center, float radius) {
  return beyond(view->pixelU, center, radius) || beyond(view->pixelV, center, radius) ||
         beyond((float)view->width * view->pixelW - view->pixelU, center, radius) ||
         beyond((float)view->height * view->pixelW - view->pixelV, center, radius);
}

/// A work item per sphere of the scene. None that is hidden, or lies behind the walls of its pixels, is set up. One
/// smaller than params.leastRadius covers as many pixels as if it were not, but its rays still meet the sphere as it
/// is, or are nearest to it where they miss it. Views are at most 2^16 tiles wide and high.
__kernel void setupSpheres(SetupParams params, ViewData view, __global const SceneSphere* spheres,
                           __global const ObjectData* objects, __global const uchar* hidden,
                           __global const uint* depths, __global ScreenSphere* screen,
                           __global RasterCounters* counters, __global uint* large) {
  if (get_global_id(0) >= params.count) return;
  uint id = params.first + (uint)get_global_id(0);
  if (hidden[id]) return;
  float4 sphere = worldSphere(&spheres[id], objects);
  float3 center = sphere.xyz;
  float depth = dot(view.depth.xyz, center) + view.depth.w;
  if (depth + sphere.w < view.nearDepth) return;
  float radius = max(sphere.w, params.leastRadius * pixelWidth(&view, depth));
  if (isBehindPixels(&view, pixelsAround(&view, center, radius), nearestDepth(depth, radius), depths)) return;

  ScreenSphere s;
  s.sphere = (float4)(center - view.origin.xyz, sphere.w);
  s.outline = s.reach = (float4)(0.0f);
  uint hides = objects[as_uint(spheres[id].color.w)].hides;
  s.facing = CDSM_SPHERE_BIT | (id << 1) | (hides ^ 1u);
  s.minDepth = depth - radius;
  bool parallel = dot(view.dirU.xyz, view.dirU.xyz) == 0.0f;
  bool ellipse = parallel || (s.minDepth >= view.nearDepth && depth >= CDSM_ELLIPSE_DEPTH * radius);
  if (!ellipse && besideView(&view, center, radius)) return;
  int4 box = ellipse ? outlineSphere(&s, &view, center, depth, radius) : (int4)(0, 0, view.width - 1, view.height - 1);
  if (box.z < box.x || box.w < box.y) return;
  int4 tiles = box >> 3;
  s.firstTile = (uint)tiles.x | ((uint)tiles.y << 16);
  s.lastTile = (uint)tiles.z | ((uint)tiles.w << 16);
  uint slot = takeSlot(tiles, params.capacity, counters, large);
  if (slot < params.capacity) screen[slot] = s;
}
