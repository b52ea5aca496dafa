// SPDX-License-Identifier: Apache-2.0
// What the rasterizer leaves for the fragment pass: triangles and spheres on the screen, (coverage mask, owner) pairs
// per tile.
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

/// A sphere on the screen. Where all of it lies in front of the eye its outline is an ellipse: pixel centres (u, v)
/// with y = v - outline.y are inside if |u - middle| <= sqrt(reach.z - 2 reach.y y - reach.x y^2),
/// middle = outline.x - outline.z y - outline.w.
typedef struct ScreenSphere {
  float4 sphere;     ///< xyz: centre - eye, w: radius, world units
  float4 outline;    ///< x, y: the centre's pixel; z, w: slope and shift of the rows' middles
  float4 reach;      ///< x, y, z: of the rows' half widths; w: 1, or 0 where there is no ellipse and rays decide
  uint firstTile, lastTile;  ///< of the box around the outline: x in the low 16 bits, y in the high ones
  uint facing;       ///< CDSM_SPHERE_BIT + sphere number * 2 + (1: a ray crosses it twice, 0: nothing gets past it)
  float minDepth;
} ScreenSphere;
CDSM_SIZE(ScreenSphere, 64);

/// In a fragment's facing: its number is a sphere's. In an owner of a coverage mask: its slot is a sphere's.
#define CDSM_SPHERE_BIT 0x80000000u
/// In an owner of a coverage mask: each of its bits is two fragments.
#define CDSM_TWICE_BIT 0x40000000u

/// Counts of one rasterization, read back by the host: what was too small is grown and the pass repeated.
typedef struct RasterCounters {
  uint wanted;  ///< triangles or spheres on the screen, may exceed the capacity
  uint large;   ///< that cover more tiles than CDSM_LARGE_TILES
  uint padding0, padding1;
} RasterCounters;
CDSM_SIZE(RasterCounters, 16);

typedef struct SetupParams {
  uint first;     ///< triangle or sphere of the scene
  uint count;
  uint capacity;  ///< triangles or spheres on the screen that there is room for
  float leastRadius;  ///< pixels around its centre that a sphere covers at least
} SetupParams;
CDSM_SIZE(SetupParams, 16);

/// Spheres that are drawn to hide others.
typedef struct WallParams {
  uint first, count;  ///< sphere of the scene, and how many
  uint stride;        ///< from one to the next
  uint padding;
} WallParams;
CDSM_SIZE(WallParams, 16);

/// Fixed-point grid of the screen corners, and the farthest a corner may lie off the screen before it is clipped.
#define CDSM_SUBPIXELS 256
#define CDSM_GUARD_PIXELS 32768.0f
/// A triangle or sphere over more tiles than this is shared out to a whole work group.
#define CDSM_LARGE_TILES 64

CDSM_SHARED_END
