// SPDX-License-Identifier: Apache-2.0
// Convex hulls in a plane, by Boost.Geometry.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace cdsm::cluster {

/// Corners of the convex hull of at least one point, each once. Which points they are is told on a fine grid, a 2^24th
/// of the points' extent, on which it is exact what lies on which side of a line: with corners that differ by rounding
/// alone, hulls of others come out wrong.
std::vector<glm::dvec2> planarHull(const std::vector<glm::dvec2>& points);

}  // namespace cdsm::cluster
