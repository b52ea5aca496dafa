// SPDX-License-Identifier: Apache-2.0
// Sorted fragments of a light's view -> one compressed visibility function per texel, handed to the memory strategy
// [Knecht 2011, §3.2, Alg. 3.1].
#include "common/math.clh"
#include "common/medium.clh"
#include "common/segments.clh"
#include "build/compress.clh"
#include "shared/frame_data.h"

/// What marching a light ray carries along.
typedef struct LightRay {
  Ray ray;
  VisibilityBuilder builder;
  float transmittance;
  float least;        // below it nothing visible can change any more
  float partsPerTau;  // of a step, see absorb()
} LightRay;

/// A step so dense that a straight line would miss the exponential by more than the tolerance (tau^2 / 8). Behind 16 parts nothing
/// is left that the tolerance would miss.
void absorbInParts(LightRay* r, float from, float to, float tau) {
  int parts = (int)clamp(ceil(tau * r->partsPerTau), 1.0f, 16.0f);
  float factor = transmittanceOf(tau / (float)parts), spacing = (to - from) / (float)parts;
  for (int i = 1; i <= parts && r->transmittance > 0.0f; ++i) {
    r->transmittance *= factor;
    if (r->transmittance < r->least) r->transmittance = 0.0f;
    fallTo(&r->builder, from + (float)(i - 1) * spacing, i == parts ? to : from + (float)i * spacing,
           r->transmittance);
  }
}

/// One step with optical depth tau > 0 between two depths; factor = exp(-tau).
CDSM_INLINE void absorb(LightRay* r, float from, float to, float tau, float factor) {
  if (tau * r->partsPerTau > 1.0f) return absorbInParts(r, from, to, tau);
  r->transmittance *= factor;
  if (r->transmittance < r->least) r->transmittance = 0.0f;
  fallTo(&r->builder, from, to, r->transmittance);
}

/// Steps i .. i + count - 1, of which `tau` are the optical depths.
CDSM_INLINE void absorbBatch(LightRay* r, const Steps* steps, int i, int count, floatN tau) {
  float depths[CDSM_BATCH], factors[CDSM_BATCH];
  vstoreN(tau, 0, depths);
  vstoreN(exp2Batch(tau * -CDSM_LOG2_E), 0, factors);
  for (int k = 0; k < count && r->transmittance > 0.0f; ++k) {
    if (depths[k] <= 0.0f) continue;
    float from = steps->start + (float)(i + k) * steps->spacing;
    absorb(r, from, steps->start + (float)(i + k + 1) * steps->spacing, depths[k], factors[k]);
  }
}

/// One volume alone: whole runs of samples in empty macrocells are skipped.
CDSM_INLINE void marchVolume(LightRay* r, SceneAccess scene, const MediumData* m, const Steps* steps CDSM_VOLUME_PARAMS) {
  IndexRay index = indexRay(m, &r->ray);
  for (int i = 0; i < steps->count;) {
    Run run = volumeRun(m, scene.cells, &index, steps, i);
    if (run.empty) {
      i = run.end;
      continue;
    }
    for (; i < run.end; i += CDSM_BATCH) {
      floatN tau = sampleExtinctions(scene, m, &index, steps, i CDSM_VOLUME_ARGS) * steps->length;
      if (!any(tau > 0.0f)) continue;
      absorbBatch(r, steps, i, min(run.end - i, CDSM_BATCH), tau);
      if (r->transmittance == 0.0f) return;
    }
    i = run.end;
  }
}

/// Any media together: extinctions add [INTERFACE, 4.2].
void marchMedia(LightRay* r, SceneAccess scene, const SegmentWalk* walk, const Steps* steps CDSM_VOLUME_PARAMS) {
  for (int i = 0; i < steps->count; ++i) {
    float3 p = r->ray.origin + sampleDepth(steps, i) * r->ray.dir;
    float extinction = 0.0f;
    for (uint k = 0; k < walk->mediumCount; ++k) {
      MediumData m = scene.media[activeMedium(walk, scene, k)];
      extinction += mediumExtinction(scene, &m, p CDSM_VOLUME_ARGS);
    }
    if (extinction <= 0.0f) continue;
    float from = steps->start + (float)i * steps->spacing;
    float tau = extinction * steps->length;
    absorb(r, from, steps->start + (float)(i + 1) * steps->spacing, tau, transmittanceOf(tau));
    if (r->transmittance == 0.0f) return;
  }
}

void marchSegment(LightRay* r, SceneAccess scene, const SegmentWalk* walk, float end,
                  float interiorStep CDSM_VOLUME_PARAMS) {
  Steps steps = stepsOf(walk->depth, end, segmentStep(walk, scene, interiorStep), &r->ray);
  if (walk->mediumCount == 1) {
    MediumData m = scene.media[activeMedium(walk, scene, 0)];
    if (m.size.w >= 0) {
      marchVolume(r, scene, &m, &steps CDSM_VOLUME_ARGS);
      return;
    }
  }
  marchMedia(r, scene, walk, &steps CDSM_VOLUME_ARGS);
}

/// The visibility function of texel (x, y), from its fragments to its nodes.
CDSM_INLINE void buildTexel(const BuildParams* params, const MapData* map, int x, int y, uint2 range,
                            __global ulong* fragments, __global const uint* initialObjects, NodeWriter* writer,
                            SceneAccess scene CDSM_VOLUME_PARAMS) {
  LightRay r;
  r.ray = rayThroughPixel(&params->view, x + 0.5f, y + 0.5f);
  r.builder.writer = *writer;
  r.builder.tolerance = params->tolerance;
  r.builder.started = false;
  r.transmittance = 1.0f;
  r.least = max(params->tolerance, 1e-5f);
  r.partsPerTau = rsqrt(8.0f * max(params->tolerance, 1e-4f));

  SegmentWalk walk = beginWalk(fragments, range, &params->view, initialObjects, scene);
  while (walk.left > 0 && r.transmittance > 0.0f) {
    float depth = nextDepth(&walk);
    if (walk.mediumCount > 0 && depth > walk.depth)
      marchSegment(&r, scene, &walk, depth, params->interiorStep CDSM_VOLUME_ARGS);
    float opacity = scene.objects[scene.triangles[nextFacing(&walk) >> 1].w].diffuse.w;
    if (opacity > 0.0f && r.transmittance > 0.0f) {
      r.transmittance *= 1.0f - opacity;
      if (r.transmittance < r.least) r.transmittance = 0.0f;
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
                              __global const MapData* maps, CDSM_MEMORY_WRITE_PARAMS, CDSM_SCENE_PARAMS) {
  CDSM_SCENE_ACCESS(scene);
  __local TileMemory shared;
  uint tile = (uint)get_group_id(0), pixel = (uint)get_local_id(0);
  int x = (int)(tile % (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel & 7u);
  int y = (int)(tile / (uint)params.view.tilesX) * CDSM_TILE + (int)(pixel >> 3);
  bool wanted = beginTile(tile, pixel, &shared, CDSM_MEMORY_WRITE_ARGS);
  if (wanted && x < params.view.width && y < params.view.height) {
    MapData map = maps[params.mapIndex];
    NodeWriter writer = beginNodes(&map, x, y, &shared, CDSM_MEMORY_WRITE_ARGS);
    buildTexel(&params, &map, x, y, ranges[tile * CDSM_TILE_PIXELS + pixel], fragments, initialObjects, &writer,
               scene CDSM_VOLUME_ARGS);
    endNodes(&writer);
  }
  endTile(tile, pixel, &shared, CDSM_MEMORY_WRITE_ARGS);
}
