// SPDX-License-Identifier: Apache-2.0
// A bounding volume hierarchy over triangles and spheres, for shadow rays.
#pragma once

#include <vector>

#include "shared/bvh_data.h"

namespace cdsm::technique {

struct Bvh {
  std::vector<shared::BvhNode> nodes;            ///< depth first, root first; empty without primitives
  std::vector<shared::BvhPrimitive> primitives;  ///< in the order of the leaves
};

/// Splits at the median of the widest axis of the centres where that is all that helps, else by the surface area
/// heuristic over 16 bins. O(n log n); at most CDSM_BVH_DEPTH deep.
Bvh buildBvh(std::vector<shared::BvhPrimitive> primitives);

}  // namespace cdsm::technique
