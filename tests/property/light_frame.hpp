// SPDX-License-Identifier: Apache-2.0
// In: a light and a map size. Out: where the texels of its maps are. A spot's map covers its cone, each of an omni
// light's six 90 degrees along an axis, a directional light's the scene; one texel more on each side.
#pragma once

#include <cdsm/scene.hpp>
#include <glm/glm.hpp>

#include "reference/ray.hpp"

namespace cdsm::property {

class LightFrame {
 public:
  /// The map of the light that sees `seen`; the scene's extent counts for a directional light alone.
  LightFrame(const Scene& scene, const Light& light, int mapSize, const glm::dvec3& seen = glm::dvec3(0.0));

  /// Width of a texel, of the wider side: at depth 1, of parallel light everywhere.
  double texel() const { return 2.0 * glm::max(halfWidth_, halfHeight_) / mapSize_; }
  /// Width of a texel in the world at this depth.
  double texelAt(double depth) const { return parallel_ ? texel() : depth * texel(); }

  /// From the image plane through the centre of a texel, counted from the left and from the top.
  reference::Ray texelRay(int column, int row) const;
  /// Depth gained by a unit of length along a texel's ray.
  double depthPerT(int column, int row) const { return glm::dot(texelRay(column, row).direction, forward_); }

  /// The world point at this depth along the axis and at these offsets from it, per unit of depth unless parallel.
  glm::dvec3 point(double x, double y, double depth) const;
  /// The inverse of point(): x, y, depth. The depth must not be 0.
  glm::dvec3 coordinates(const glm::dvec3& pointWorld) const;

 private:
  glm::dvec3 position_, forward_, right_, up_;
  double halfWidth_, halfHeight_;
  int mapSize_;
  bool parallel_;
};

}  // namespace cdsm::property
