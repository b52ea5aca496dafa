// SPDX-License-Identifier: Apache-2.0
// The hierarchy of boxes over the scene's triangles that shadow rays walk.
#pragma once
#include "shared/types.h"

CDSM_SHARED_BEGIN

/// Inner node: its left child is the next node, `link` the right one. Leaf: `count` triangles from number `link` on.
typedef struct BvhNode {
  float4 low;   ///< world; w unused
  float4 high;
  uint link;
  uint count;   ///< 0: inner node
  uint padding0, padding1;
} BvhNode;
CDSM_SIZE(BvhNode, 48);

/// A triangle in world space, in the order of the leaves. a.w: number of its object, as the bits of a float.
typedef struct BvhTriangle {
  float4 a, b, c;
} BvhTriangle;
CDSM_SIZE(BvhTriangle, 48);

/// Depth of the hierarchy that a walk has room for; the host builds no deeper one.
#define CDSM_BVH_DEPTH 48

CDSM_SHARED_END
