// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of spheres: a grid of how dense they are, and what of the surroundings is seen from its cells.
#pragma once
#include "shared/types.h"

CDSM_SHARED_BEGIN

/// Cubic cells around all spheres. Lengths in cells start at the grid's lowest corner; the middle of the first cell is
/// at (0.5, 0.5, 0.5).
typedef struct OcclusionGrid {
  float4 corner;  ///< xyz: world, w: edge of a cell in world units
  int4 size;      ///< cells along x, y, z; w: 1, or 0 where there is no ambient occlusion
} OcclusionGrid;
CDSM_SIZE(OcclusionGrid, 32);

#define CDSM_OCCLUSION_LEVELS 8
#define CDSM_OCCLUSION_STEPS 32

/// Density of the spheres in levels, each of cells twice as wide as those of the one before, with a border of one cell
/// that stays empty. A cell holds the optical depth across an edge of the first level's cells, times
/// CDSM_OCCLUSION_ONE.
typedef struct OcclusionParams {
  OcclusionGrid grid;
  int4 levels[CDSM_OCCLUSION_LEVELS];   ///< cells along x, y, z with the border; w: number of the first cell
  float4 steps[CDSM_OCCLUSION_STEPS];   ///< x: distance from the point, cells; y: length, cells, times the strength
                                        ///< / CDSM_OCCLUSION_ONE; z: level
  uint directionCount, stepCount;
  uint firstCell, lastCell;             ///< those in between are looked at in this launch, the last one not
  uint buried;                          ///< depth of all cells around one from which on it sees nothing
  uint padding0, padding1, padding2;
} OcclusionParams;
CDSM_SIZE(OcclusionParams, 704);

/// Spheres to be put into the grid.
typedef struct DensityParams {
  OcclusionGrid grid;
  uint first, count;  ///< spheres of the scene
  uint slices;        ///< work items that share the cells of a sphere
  uint padding;
} DensityParams;
CDSM_SIZE(DensityParams, 48);

/// An optical depth of 1, and the largest that a cell holds: 1 / 50 of the light passes it.
#define CDSM_OCCLUSION_ONE 1048576.0f
#define CDSM_OCCLUSION_MOST 4194304u

CDSM_SHARED_END
