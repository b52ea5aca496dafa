// SPDX-License-Identifier: Apache-2.0
// What the rasterizer leaves for the fragment pass: screen triangles, (coverage mask, triangle) pairs per tile.
#pragma once
#include "shared/types.h"

CDSM_SHARED_BEGIN

/// A triangle on the screen, clipped, its corners on a grid of 1/256 pixel, turned so that its area is positive.
typedef struct ScreenTriangle {
  float4 plane;      ///< xyz: world normal n, w: dot(n, v0 - eye); depth of a pixel's ray: see fragmentDepth()
  int2 a, b, c;      ///< corners, 1/256 pixel
  float minDepth, maxDepth;
  uint facing;       ///< triangle number * 2 + (1: seen from behind)
  uint padding0, padding1, padding2;
} ScreenTriangle;
CDSM_SIZE(ScreenTriangle, 64);

/// Counts of one rasterization, read back by the host: what was too small is grown and the pass repeated.
typedef struct RasterCounters {
  uint screenTriangles;  ///< wanted, may exceed the capacity
  uint largeTriangles;   ///< that cover more tiles than CDSM_LARGE_TILES
  uint padding0, padding1;
} RasterCounters;
CDSM_SIZE(RasterCounters, 16);

typedef struct SetupParams {
  uint firstTriangle;
  uint triangleCount;
  uint capacity;  ///< screen triangles there is room for
  uint padding;
} SetupParams;
CDSM_SIZE(SetupParams, 16);

/// Fixed-point grid of the screen corners, and the farthest a corner may lie off the screen before it is clipped.
#define CDSM_SUBPIXELS 256
#define CDSM_GUARD_PIXELS 32768.0f
/// A triangle over more tiles than this is shared out to a whole work group.
#define CDSM_LARGE_TILES 64

CDSM_SHARED_END
