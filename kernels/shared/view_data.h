// SPDX-License-Identifier: Apache-2.0
// One camera, of the viewer or of a light: pixels of a view, world rays through them, depth along the view axis.
#pragma once
#include "shared/types.h"

CDSM_SHARED_BEGIN

/// pixel u = dot(pixelU, (p, 1)) / w, pixel v likewise, w = dot(pixelW, (p, 1)); v grows downwards, pixel centres at
/// +0.5. Perspective views: depth = w, the distance from the image plane along the axis. Parallel views: w = 1.
/// The ray through (u, v): point(depth) = origin + u * originU + v * originV + depth * (dir + u * dirU + v * dirV).
typedef struct ViewData {
  float4 pixelU, pixelV, pixelW, depth;
  float4 origin, originU, originV;
  float4 dir, dirU, dirV;
  int width, height;      ///< pixels
  int tilesX, tilesY;     ///< of 8 x 8 pixels
  float nearDepth;        ///< nothing nearer is seen, > 0 for perspective views
  uint initialCount;      ///< objects that contain the eye
  uint padding0, padding1;
} ViewData;
CDSM_SIZE(ViewData, 192);

#define CDSM_TILE 8
#define CDSM_TILE_PIXELS 64

CDSM_SHARED_END
