// SPDX-License-Identifier: Apache-2.0
// Does a mesh enclose a volume, and is a point inside it?
#pragma once

#include <cstddef>

#include <cdsm/scene.hpp>

namespace cdsm::scene {

/// The number of edges that stop a mesh from being closed. Equal positions are joined first (files repeat a vertex
/// for every normal); then each edge must be run through as often in one direction as in the other, and what is left
/// over is counted. 0: closed. Needs finite positions and indices in range; takes O(n log n).
std::size_t openEdges(const MeshData& mesh);

/// How often the mesh winds around `pointWorld`: 1 inside and 0 outside a closed mesh whose triangles run
/// counter-clockwise seen from outside, -1 inside when they run clockwise or the transform mirrors; between these for
/// an open one. Sum of solid angles over 4 pi [Van Oosterom & Strackee 1983], in double precision, over all triangles.
double windingNumber(const MeshData& mesh, const glm::mat4& worldFromObject, const glm::dvec3& pointWorld);

}  // namespace cdsm::scene
