// SPDX-License-Identifier: Apache-2.0
// What debug pictures are made from: where a camera ray first sees something, and what a light's maps hold there.
#pragma once
#include "shared/types.h"
#include "shared/view_data.h"

CDSM_SHARED_BEGIN

typedef struct ProbeParams {
  ViewData view;
  float interiorStep;  ///< as in BuildParams
  float bias;          ///< as in ShadeParams
  uint light;
  uint padding;
} ProbeParams;
CDSM_SIZE(ProbeParams, 208);

typedef struct MapProbe {
  uint seen;      ///< 0 | 1: the ray meets something visible
  uint nodes;     ///< of the texels that the point is looked up in, all of the light's maps together
  uint map;       ///< number + 1 of the map that says most about the point, 0: the point lies in none
  float checker;  ///< 0 .. 1: that map's texels, dark and bright by turns, averaged over the pixel
} MapProbe;
CDSM_SIZE(MapProbe, 16);

CDSM_SHARED_END
