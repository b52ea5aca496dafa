// SPDX-License-Identifier: Apache-2.0
// In: corners of triangles, three after three. Out: an indexed mesh without doubles.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <cdsm/scene.hpp>

namespace cdsm::io {

struct Corner {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};  ///< of any length; (0, 0, 0) if there is none
};

/// Joins corners that are equal bit for bit (zeros of either sign are), drops triangles without area and with them the
/// vertices that only they use. Normals are kept, at length 1, if no corner lacks one. Order is that of the corners.
MeshData joinCorners(const std::vector<Corner>& corners);

}  // namespace cdsm::io
