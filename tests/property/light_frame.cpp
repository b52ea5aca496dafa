// SPDX-License-Identifier: Apache-2.0
// The geometry of a spot light's map, worked out a second time for the tests.
#include "light_frame.hpp"

#include <cmath>

namespace cdsm::property {

LightFrame::LightFrame(const Light& light, int mapSize) : position_(light.position), mapSize_(mapSize) {
  forward_ = glm::normalize(glm::dvec3(light.target) - position_);
  const glm::dvec3 hint = std::abs(forward_.y) > 0.99 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  right_ = glm::normalize(glm::cross(forward_, hint));
  up_ = glm::cross(right_, forward_);
  halfWidth_ = std::tan(glm::radians(static_cast<double>(light.cutoff))) * mapSize / (mapSize - 2.0);
}

glm::dvec3 LightFrame::texelDirection(int column, int row) const {
  const double x = halfWidth_ * (2.0 * (column + 0.5) / mapSize_ - 1.0);
  const double y = halfWidth_ * (1.0 - 2.0 * (row + 0.5) / mapSize_);
  return forward_ + x * right_ + y * up_;
}

glm::dvec3 LightFrame::point(double x, double y, double depth) const {
  return position_ + depth * (forward_ + x * right_ + y * up_);
}

glm::dvec3 LightFrame::coordinates(const glm::dvec3& pointWorld) const {
  const glm::dvec3 offset = pointWorld - position_;
  const double depth = glm::dot(offset, forward_);
  return {glm::dot(offset, right_) / depth, glm::dot(offset, up_) / depth, depth};
}

}  // namespace cdsm::property
