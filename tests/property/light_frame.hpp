// SPDX-License-Identifier: Apache-2.0
// In: a spot light and a map size. Out: where the texels of its one map are. The map's camera looks from the light to
// its target and covers the cone and one texel more on each side.
#pragma once

#include <cdsm/scene.hpp>
#include <glm/glm.hpp>

namespace cdsm::property {

class LightFrame {
 public:
  LightFrame(const Light& light, int mapSize);

  /// Width of a texel at depth 1.
  double texel() const { return 2.0 * halfWidth_ / mapSize_; }

  /// Through the centre of a texel, counted from the left and from the top; its length along the axis is 1.
  glm::dvec3 texelDirection(int column, int row) const;

  /// The world point at this depth along the axis and at these offsets from it per unit of depth.
  glm::dvec3 point(double x, double y, double depth) const;

  /// The inverse of point(): x, y, depth. The depth must not be 0.
  glm::dvec3 coordinates(const glm::dvec3& pointWorld) const;

 private:
  glm::dvec3 position_, forward_, right_, up_;
  double halfWidth_;
  int mapSize_;
};

}  // namespace cdsm::property
