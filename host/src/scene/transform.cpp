// SPDX-License-Identifier: Apache-2.0
// Affine transforms: composed in double precision, so that a turn by 90 degrees is as exact as floats can say.
#include "scene/transform.hpp"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace cdsm::scene {
namespace {

/// Determinant over the product of the columns' lengths, below which a float inverse is mostly rounding error.
constexpr double kFlat = 1e-6;

/// Part of the scale by which the axes of a similarity may differ in length, and from right angles.
constexpr double kAlike = 1e-5;

bool isFinite(const glm::mat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return true;
}

}  // namespace

glm::mat4 composeTransform(const glm::vec3& position, const glm::vec3& axis, float degrees, const glm::vec3& scale) {
  glm::dmat4 transform = glm::translate(glm::dmat4(1.0), glm::dvec3(position));
  if (degrees != 0.0f) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(axis));
    transform = glm::rotate(transform, glm::radians(static_cast<double>(degrees)), direction);
  }
  return glm::mat4(glm::scale(transform, glm::dvec3(scale)));
}

bool isInvertibleAffine(const glm::mat4& matrix) {
  if (!isFinite(matrix)) return false;
  if (matrix[0][3] != 0.0f || matrix[1][3] != 0.0f || matrix[2][3] != 0.0f || matrix[3][3] != 1.0f) return false;
  const glm::dmat3 linear(matrix);
  const double size = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  if (!(std::abs(glm::determinant(linear)) > kFlat * size)) return false;
  return isFinite(glm::inverse(matrix));
}

bool isSimilarity(const glm::mat4& matrix) {
  const glm::dmat3 linear(matrix), squares = glm::transpose(linear) * linear;
  const double square = squares[0][0];
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if (std::abs(squares[column][row] - (row == column ? square : 0.0)) > kAlike * square) return false;
  return true;
}

}  // namespace cdsm::scene
