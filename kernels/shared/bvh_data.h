// SPDX-License-Identifier: Apache-2.0
// The hierarchy of boxes over the scene's triangles and spheres that shadow rays walk.
#pragma once
#include "shared/types.h"

CDSM_SHARED_BEGIN

/// Inner node: its left child is the next node, `link` the right one. Leaf: `count` primitives from number `link` on.
typedef struct BvhNode {
  float4 low;   ///< world; w unused
  float4 high;
  uint link;
  uint count;   ///< 0: inner node
  uint padding0, padding1;
} BvhNode;
CDSM_SIZE(BvhNode, 48);

/// A triangle or a sphere in world space, in the order of the leaves.
typedef struct BvhPrimitive {
  float4 a;  ///< corner, or centre; w: number of its object, as the bits of a float
  float4 b;  ///< corner; w: radius of a sphere, 0 for a triangle
  float4 c;  ///< corner
} BvhPrimitive;
CDSM_SIZE(BvhPrimitive, 48);

/// Depth of the hierarchy that a walk has room for; the host builds no deeper one.
#define CDSM_BVH_DEPTH 48

CDSM_SHARED_END
