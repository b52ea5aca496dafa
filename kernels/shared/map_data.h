// SPDX-License-Identifier: Apache-2.0
// Lights and their deep shadow maps as the lookup sees them, and what building one map needs.
#pragma once
#include "shared/types.h"
#include "shared/view_data.h"

CDSM_SHARED_BEGIN

/// From a point p the way to the light is position.xyz - position.w * p.
typedef struct LightData {
  float4 position;   ///< spot, omni: world, w = 1; directional: unit, towards the light, w = 0
  float4 axis;       ///< of a spot's cone: unit, w: tangent of the cutoff angle; 0 where all is lit
  float4 color;      ///< linear RGB
  uint firstMap;
  uint mapCount;
  uint type;         ///< CDSM_LIGHT_...
  float front;       ///< directional: dot(position.xyz, p) of a plane that the whole scene lies behind
  uint formerCount;  ///< maps behind those that are fading out; each set of maps tells the whole transmittance
  float share;       ///< of the first set, where a second one fades out
  uint firstShadowBlock;  ///< cache "volume": of its shadow volumes, in CDSM_SHADOW_BLOCK voxels
  uint mediumCount;  ///< of the scene
} LightData;
CDSM_SIZE(LightData, 80);

#define CDSM_LIGHT_SPOT 0u
#define CDSM_LIGHT_OMNI 1u
#define CDSM_LIGHT_DIRECTIONAL 2u

/// One map: where a point lands in it and where its texels' nodes are kept.
typedef struct MapData {
  float4 texelU, texelV, texelW, depth;  ///< as ViewData's rows
  float4 origin, originU, originV;       ///< rays per texel, as ViewData's
  float4 dir, dirU, dirV;
  int4 atlasOffset;                      ///< atlas: x, y, layer [Knecht 2011, eq. 4.7]
  int width, height;                     ///< texels
  uint firstTexel;                       ///< of this map in the lookup table
  uint firstNode;                        ///< of this map in the pool of nodes; all strategies but atlas
  float nearDepth;                       ///< nothing in front of it attenuates
  uint face;                             ///< side of an omni light whose points are looked up here, or CDSM_FACE_ANY
  uint wideTable;                        ///< exact: 1: 32-bit entries in its table, 0: 16-bit ones
  uint firstTile;                        ///< of this map in the depth scales of tiles, for formats that need them
} MapData;
CDSM_SIZE(MapData, 208);

/// Sides of an omni light: 0 .. 5 as +x, -x, +y, -y, +z, -z.
#define CDSM_FACE_ANY 6u

/// In memory strategies the depth of a node is as the format of nodes stores it: (depth - x) * y of the tile's scale.
typedef float2 DepthScale;

/// Sizes of the memory strategy in use.
typedef struct MemoryParams {
  int4 atlasSize;       ///< atlas: texels along x and y, layers of one map (even)
  uint capacity;        ///< while building, there is room for: chunks (chunked), nodes of the map (exact, tiled)
  uint firstNode;       ///< exact, tiled, while building: of the map in the pool of nodes
  uint scratchChunks;   ///< exact, tiled, while building: that a tile may use; 0: nodes are counted, none is kept
  uint fill;            ///< exact, tiled, while building: 1: only tiles that have a place but no nodes yet are built
  uint nodesPerTexel;   ///< strategies with the same room for every texel
  uint padding0, padding1, padding2;
} MemoryParams;
CDSM_SIZE(MemoryParams, 48);

/// What building a map wanted; more than the capacity means: make room and build again.
typedef struct BuildCounters {
  uint chunks;                 ///< chunked: chunks handed out
  uint maxNodes;               ///< most nodes of a texel
  uint maxTileNodes;           ///< exact, tiled: most nodes of a tile
  uint unfilledTiles;          ///< exact, tiled: that have a place but no nodes yet
  uint nodesLow, nodesHigh;    ///< exact, tiled: nodes of all texels, 64 bits
  uint roomLow, roomHigh;      ///< exact, tiled: nodes there must be room for, 64 bits
} BuildCounters;
CDSM_SIZE(BuildCounters, 32);

/// Nodes of a chunk. A chunk belongs to one texel, so nobody races for it and none is lost.
#define CDSM_CHUNK_NODES 8
/// Layers of a block of the strategy "tiled", which covers a tile.
#define CDSM_BLOCK_LAYERS 4
/// Words per tile of the strategy "exact": while building, and of the finished table with 16-bit entries.
#define CDSM_EXACT_WORDS 65
#define CDSM_EXACT_NARROW_WORDS 34
/// On image devices: pixels of 16 bytes in a row of the texture of nodes, as a power of two.
#define CDSM_NODE_TEXTURE_BITS 12

CDSM_SHARED_END
