// SPDX-License-Identifier: Apache-2.0
// Triangles of the scene -> triangles on the screen, clipped [Knecht 2011, §3.1.1].
#include "build/coverage.clh"
#include "build/screen_slot.clh"
#include "common/affine.clh"

/// A corner on its way to the screen: xy = pixel * w, z = depth, w as ViewData says; nearer is smaller depth.
float4 cornerInView(const ViewData* view, float3 pointWorld) {
  return (float4)(dot(view->pixelU.xyz, pointWorld) + view->pixelU.w,
                  dot(view->pixelV.xyz, pointWorld) + view->pixelV.w,
                  dot(view->depth.xyz, pointWorld) + view->depth.w,
                  dot(view->pixelW.xyz, pointWorld) + view->pixelW.w);
}

/// Distance to clip plane k, >= 0 inside: 0 near, 1-4 the guard band around the screen, where fixed point would end.
float clipDistance(float4 corner, int k, const ViewData* view) {
  switch (k) {
    case 0: return corner.z - view->nearDepth;
    case 1: return corner.x + CDSM_GUARD_PIXELS * corner.w;
    case 2: return (CDSM_GUARD_PIXELS + (float)view->width) * corner.w - corner.x;
    case 3: return corner.y + CDSM_GUARD_PIXELS * corner.w;
    default: return (CDSM_GUARD_PIXELS + (float)view->height) * corner.w - corner.y;
  }
}

/// Sutherland-Hodgman against one plane; `polygon` has room for 9 corners, returns the new number of corners. An edge
/// is always cut from its inner to its outer end, so that both triangles at the edge get the same new corner. A
/// triangle and five planes make 8 corners; more could only come of rounding in polygons that lie in a plane, whose
/// area is 0.
int clipPolygon(float4* polygon, int count, int plane, const ViewData* view) {
  float4 clipped[9];
  int kept = 0;
  for (int i = 0; i < count && kept < 8; ++i) {
    float4 p = polygon[i], q = polygon[i + 1 < count ? i + 1 : 0];
    float dp = clipDistance(p, plane, view), dq = clipDistance(q, plane, view);
    if (dp >= 0.0f) clipped[kept++] = p;
    if (dp >= 0.0f && dq < 0.0f) clipped[kept++] = p + (q - p) * (dp / (dp - dq));
    if (dp < 0.0f && dq >= 0.0f) clipped[kept++] = q + (p - q) * (dq / (dq - dp));
  }
  for (int i = 0; i < kept; ++i) polygon[i] = clipped[i];
  return kept;
}

int2 screenPoint(float4 corner) {
  return convert_int2_rte(corner.xy / corner.w * (float)CDSM_SUBPIXELS);
}

long twiceArea(int2 a, int2 b, int2 c) {
  return ((long)b.x - a.x) * ((long)c.y - a.y) - ((long)b.y - a.y) * ((long)c.x - a.x);
}

/// Writes one screen triangle if it covers a pixel centre.
void emitScreenTriangle(const ViewData* view, ScreenTriangle t, __global ScreenTriangle* screen, uint capacity,
                        __global RasterCounters* counters, __global uint* large) {
  long area = twiceArea(t.a, t.b, t.c);
  if (area == 0) return;
  int4 box = coveredPixels(t.a, t.b, t.c, view->width, view->height);
  if (box.z < box.x || box.w < box.y) return;
  if (area < 0) {
    int2 swap = t.b;
    t.b = t.c;
    t.c = swap;
  } else {
    t.facing |= 1u;  // counter-clockwise on a screen whose y points down: seen from behind
  }
  uint slot = takeSlot(box >> 3, capacity, counters, large);
  if (slot < capacity) screen[slot] = t;
}

/// A work item per scene triangle: to the screen, clipped, as one or more screen triangles.
__kernel void setupTriangles(SetupParams params, ViewData view, __global const uint4* triangles,
                             __global const float* positions, __global const ObjectData* objects,
                             __global ScreenTriangle* screen, __global RasterCounters* counters,
                             __global uint* large) {
  if (get_global_id(0) >= params.count) return;
  uint id = params.first + (uint)get_global_id(0);
  uint4 corners = triangles[id];
  Affine worldFromObject = objects[corners.w].worldFromObject;
  float3 a = transformPoint(worldFromObject, vload3(corners.x, positions));
  float3 b = transformPoint(worldFromObject, vload3(corners.y, positions));
  float3 c = transformPoint(worldFromObject, vload3(corners.z, positions));
  float4 polygon[9];
  polygon[0] = cornerInView(&view, a);
  polygon[1] = cornerInView(&view, b);
  polygon[2] = cornerInView(&view, c);

  int count = 3;
  for (int plane = 0; plane < 5; ++plane) {
    bool inside = true;
    for (int i = 0; i < count; ++i) inside = inside && clipDistance(polygon[i], plane, &view) >= 0.0f;
    if (!inside) count = clipPolygon(polygon, count, plane, &view);
  }
  if (count < 3) return;

  ScreenTriangle t;
  float3 normal = cross(b - a, c - a);
  t.plane = (float4)(normal, dot(normal, a - view.origin.xyz));
  t.minDepth = polygon[0].z;
  t.maxDepth = polygon[0].z;
  for (int i = 1; i < count; ++i) {
    t.minDepth = min(t.minDepth, polygon[i].z);
    t.maxDepth = max(t.maxDepth, polygon[i].z);
  }
  t.padding0 = t.padding1 = t.padding2 = 0;
  for (int i = 1; i + 1 < count; ++i) {
    t.facing = id << 1;
    t.a = screenPoint(polygon[0]);
    t.b = screenPoint(polygon[i]);
    t.c = screenPoint(polygon[i + 1]);
    emitScreenTriangle(&view, t, screen, params.capacity, counters, large);
  }
}
