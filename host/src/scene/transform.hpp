// SPDX-License-Identifier: Apache-2.0
// Affine transforms: made from a scene file's parts, and tested for use.
#pragma once

#include <glm/glm.hpp>

namespace cdsm::scene {

/// Scale first, then a right-handed rotation by `degrees` about `axis` (any length; ignored when `degrees` is 0), then
/// the move to `position`.
glm::mat4 composeTransform(const glm::vec3& position, const glm::vec3& axis, float degrees, const glm::vec3& scale);

/// True when all elements are finite, the last row is 0 0 0 1, and the matrix has a finite inverse in floats that is
/// not all rounding.
bool isInvertibleAffine(const glm::mat4& matrix);

/// True when an invertible matrix scales all axes alike, up to rounding: it turns spheres into spheres.
bool isSimilarity(const glm::mat4& matrix);

}  // namespace cdsm::scene
