// SPDX-License-Identifier: Apache-2.0
// Pictures of internals: where each camera ray first meets something visible, which map of a light the point there is
// looked up in, and how many nodes the texels have.
#include "common/medium.clh"
#include "common/segments.clh"
#include "common/surface.clh"
#include "shared/debug_data.h"
#include "technique/deep_shadow_map.clh"

/// Transparency below which something is seen: less opacity changes no 8-bit pixel.
#define CDSM_UNSEEN (254.0f / 255.0f)

/// The first point of a ray that is seen.
typedef struct SeenPoint {
  SurfacePoint at;  // of a medium the normal is towards the viewer
  bool seen, surface;
} SeenPoint;

/// Depth in the segment from walk->depth to `end` at which its media are seen, or INFINITY. The steps are those of the
/// picture.
float seenDepth(float* transparency, const Ray* ray, SceneAccess scene, const SegmentWalk* walk, float end,
                float interiorStep CDSM_VOLUME_PARAMS) {
  Steps steps = stepsOf(walk->depth, end, segmentStep(walk, scene, interiorStep), ray);
  MediumData first = scene.media[activeMedium(walk, scene, 0)];
  bool single = walk->mediumCount == 1 && first.size.w >= 0;
  IndexRay index = indexRay(&first, ray);
  Run run;
  run.end = 0;
  for (int i = 0; i < steps.count; ++i) {
    if (single && i >= run.end) {
      run = volumeRun(&first, scene.cells, &index, &steps, i);
      if (run.empty) {
        i = run.end - 1;
        continue;
      }
    }
    float depth = sampleDepth(&steps, i);
    float extinction = activeExtinction(walk, scene, ray->origin + depth * ray->dir CDSM_VOLUME_ARGS);
    *transparency *= exp(-extinction * steps.length);
    if (*transparency <= CDSM_UNSEEN) return depth;
  }
  return INFINITY;
}

SeenPoint firstSeen(const Ray* ray, SceneAccess scene, SegmentWalk* walk,
                    const ProbeParams* params CDSM_VOLUME_PARAMS) {
  SeenPoint p;
  p.seen = p.surface = p.at.farSide = false;
  p.at.bias = params->bias;
  float transparency = 1.0f, depth = INFINITY;
  uint facing = 0;
  while (walk->left > 0 && !p.seen) {
    float next = nextDepth(walk);
    if (walk->mediumCount > 0 && next > walk->depth)
      depth = seenDepth(&transparency, ray, scene, walk, next, params->interiorStep CDSM_VOLUME_ARGS);
    p.seen = depth < INFINITY;
    facing = nextFacing(walk);
    if (!p.seen) transparency *= 1.0f - scene.objects[surfaceObject(scene, facing)].diffuse.w;
    if (!p.seen && transparency <= CDSM_UNSEEN) {
      p.seen = p.surface = true;
      depth = next;
    }
    passFragment(walk, scene);
  }
  p.at.point = ray->origin + (p.seen ? depth : 0.0f) * ray->dir;
  p.at.normal = p.surface ? surfaceNormals(scene, facing, p.at.point).plane : -ray->dir / ray->length;
  return p;
}

/// Antiderivative of the wave that is 1 where the texel is even and -1 where it is odd.
float evenOddSum(float texels) {
  float part = texels - 2.0f * floor(0.5f * texels);
  return 1.0f - fabs(part - 1.0f);
}

/// Mean of that wave over `width` texels around `at`.
float evenOddMean(float at, float width) {
  return (evenOddSum(at + 0.5f * width) - evenOddSum(at - 0.5f * width)) / width;
}

/// Wider pixels are grey, however wide they are.
#define CDSM_WIDEST_PIXEL 64.0f

/// Width and height of the pixel in texels of a map: how far its neighbours' rays meet the plane of what is seen.
float2 pixelInTexels(__global const MapData* map, uint side, const MapPoint* at, const SurfacePoint* p,
                     const ViewData* view, float x, float y) {
  float2 size = (float2)(1e-3f);
  for (int k = 0; k < 2; ++k) {
    Ray ray = rayThroughPixel(view, x + (k == 0 ? 1.0f : 0.0f), y + (k == 0 ? 0.0f : 1.0f));
    float depth = dot(p->normal, p->point - ray.origin) / dot(p->normal, ray.dir);
    MapPoint next = pointInMap(map, side, ray.origin + depth * ray.dir);
    float2 apart = fabs((float2)(next.u - at->u, next.v - at->v));
    size = max(size, depth > 0.0f && all(isfinite(apart)) ? apart : (float2)(CDSM_WIDEST_PIXEL));
  }
  return min(size, CDSM_WIDEST_PIXEL);
}

/// Of all colours of light together.
float probeTransmittance(__global const MapData* map, uint side, const SeenPoint* p, float3 lookup,
                         CDSM_TECHNIQUE_PARAMS) {
  return meanOf(p->surface ? mapTransmittanceSurface(map, side, &p->at, lookup, CDSM_TECHNIQUE_ARGS)
                           : mapTransmittance(map, side, lookup, CDSM_TECHNIQUE_ARGS));
}

/// Transmittances that differ by less are taken for the same.
#define CDSM_SAME_LIGHT 0.01f

/// The map that says most about a point is the one that lets least light through; of those that agree, the sharpest.
MapProbe probePoint(const SeenPoint* p, __global const LightData* light, const ViewData* view, float x, float y,
                    CDSM_TECHNIQUE_PARAMS) {
  MemoryParams memory = technique.memory;
  MapProbe probe;
  probe.seen = p->seen ? 1u : 0u;
  probe.nodes = probe.map = 0;
  probe.checker = 0.5f;
  if (!p->seen || !litPoint(light, p->at.point)) return probe;
  float3 lookup = p->surface ? biasedPoint(light, &p->at) : p->at.point;
  uint side = sideOf(light, lookup);
  float least = 2.0f, sharpest = 0.0f;
  for (uint m = light->firstMap; m < light->firstMap + light->mapCount; ++m) {
    __global const MapData* map = &maps[m];
    MapPoint at = pointInMap(map, side, lookup);
    if (!at.seen) continue;
    int u = min((int)at.u, map->width - 1), v = min((int)at.v, map->height - 1);
    probe.nodes += texelNodes(map, u, v, CDSM_MEMORY_READ_ARGS).count;
    float t = probeTransmittance(map, side, p, lookup, CDSM_TECHNIQUE_ARGS);
    float2 pixel = pixelInTexels(map, side, &at, &p->at, view, x, y);
    float sharpness = pixel.x * pixel.y;
    if (t > least + CDSM_SAME_LIGHT || (t >= least - CDSM_SAME_LIGHT && sharpness <= sharpest)) continue;
    least = t;
    sharpest = sharpness;
    probe.map = m + 1;
    probe.checker = 0.5f + 0.5f * evenOddMean(at.u, pixel.x) * evenOddMean(at.v, pixel.y);
  }
  return probe;
}

/// A group per tile, an item per pixel. probes: row after row.
__kernel void probeMaps(ProbeParams params, __global ulong* fragments, __global const uint2* ranges,
                        __global const LightData* lights, __global MapProbe* probes, CDSM_TECHNIQUE_PARAMS,
                        CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  int x = (int)(tile % (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  if (x >= params.view.width || y >= params.view.height) return;
  Ray ray = rayThroughPixel(&params.view, x + 0.5f, y + 0.5f);
  SegmentWalk walk = beginWalk(fragments, ranges[tile * CDSM_TILE_PIXELS + pixel], &params.view, initialObjects, scene);
  SeenPoint p = firstSeen(&ray, scene, &walk, &params CDSM_VOLUME_ARGS);
  probes[(size_t)y * (size_t)params.view.width + (size_t)x] =
      probePoint(&p, &lights[params.light], &params.view, x + 0.5f, y + 0.5f, CDSM_TECHNIQUE_ARGS);
}
