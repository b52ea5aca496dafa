// SPDX-License-Identifier: Apache-2.0
// Arguments of the kernels that march rays: building maps, shading the image, answering queries.
#pragma once
#include "shared/map_data.h"
#include "shared/occlusion_data.h"
#include "shared/scene_data.h"
#include "shared/types.h"
#include "shared/view_data.h"

CDSM_SHARED_BEGIN

typedef struct BuildParams {
  ViewData view;
  float tolerance;      ///< epsilon of the compression, in opacity
  float interiorStep;   ///< ray step where only constant media are, world units
  uint mapIndex;
  uint padding;
} BuildParams;
CDSM_SIZE(BuildParams, 208);

typedef struct DepthParams {
  ViewData view;
  float threshold;      ///< opacity over which a surface stops the light
  uint firstTexel;      ///< of the map
  uint seed;            ///< stochastic: of the map's random numbers, which are in units of 2^-32:
  uint patternX;        ///< what is added from texel to texel along x and y
  uint patternY;
  uint jitter;          ///< width of what each texel draws by itself
  uint channelShift;    ///< what is added from channel to channel
  uint padding;
} DepthParams;
CDSM_SIZE(DepthParams, 224);

typedef struct ShadeParams {
  ViewData view;
  float4 ambient;       ///< i_a
  float interiorStep;   ///< as in BuildParams
  float bias;           ///< world units a surface point is moved towards the light
  uint lightCount;
  float lookupTolerance;  ///< lookups along a ray are interpolated where they differ by less
  OcclusionGrid occlusion;
} ShadeParams;
CDSM_SIZE(ShadeParams, 256);

typedef struct QueryParams {
  uint pointCount;
  uint light;
  uint pointStride;     ///< floats from a point to the next
  uint padding;
} QueryParams;
CDSM_SIZE(QueryParams, 16);

/// Part of one light's shadow volume of one volume.
typedef struct FillParams {
  Affine worldFromIndex;
  uint firstCell;  ///< macrocell of the first group
  uint light;
  uint medium;
  uint padding;
} FillParams;
CDSM_SIZE(FillParams, 64);

/// What any technique may need to know; each uses its part.
typedef struct TechniqueParams {
  MemoryParams memory;
  uint bilinear;     ///< techniques with maps: 1: texels weighted by the point's place among them, 0: nearest
  uint mediumCount;  ///< shadow-rays: of the scene
  uint nodeCount;    ///< shadow-rays: of the hierarchy of triangles and spheres, 0: it is empty
  float texelBias;   ///< techniques with maps: texel widths that surface points are moved towards the light
  uint opaque;       ///< shadow-rays: 1: all or nothing
  float threshold;   ///< shadow-rays, opaque: opacity over which a surface stops the light
  int pcf;           ///< shadow-map: texels of the filter around the one looked up
  int samples;       ///< stochastic: texels looked up at once
  int patch;         ///< implicit-sphere: rings of texels around the one looked up; negative: as many as it takes
  float softness, softnessDistance, softnessExponent;  ///< implicit-sphere: s, b, x
} TechniqueParams;
CDSM_SIZE(TechniqueParams, 96);

CDSM_SHARED_END
