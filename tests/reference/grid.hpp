// SPDX-License-Identifier: Apache-2.0
// In: a volume of the scene. Out: its value, gradient, extinction and colour at world points, in double precision.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>
#include <glm/glm.hpp>

#include "ray.hpp"

namespace cdsm::reference {

struct Interval {
  double begin, end;  ///< t along a ray; empty where begin >= end
};

/// A volume: trilinear between voxel centres, clamped at the border, its box half a voxel beyond the outer centres.
class Grid {
 public:
  explicit Grid(const Volume& volume);

  /// Where the ray is inside the volume's box; may begin before 0.
  Interval inside(const Ray& ray) const;

  double value(const glm::dvec3& pointWorld) const;

  /// Unit gradient in world space from central differences of one voxel to each side; 0 where the field is flat.
  glm::dvec3 normal(const glm::dvec3& pointWorld) const;

  /// 1 / world length: -ln(1 - a) / unitDistance of the interpolated value's opacity a, capped at 0.9999.
  double extinction(const glm::dvec3& pointWorld) const;

  glm::dvec3 color(const glm::dvec3& pointWorld) const;

  /// What of the light's colours gets through where the volume interacts.
  glm::dvec3 transmission(const glm::dvec3& pointWorld) const;

  /// The shortest edge of a voxel in world units.
  double smallestEdge() const { return smallestEdge_; }

 private:
  double valueAtIndex(const glm::dvec3& index) const;
  double voxel(int x, int y, int z) const;
  glm::dvec3 indexOf(const glm::dvec3& pointWorld) const;

  std::vector<double> voxels_;
  glm::ivec3 size_;
  glm::dmat4 indexFromWorld_;
  double smallestEdge_;
  double largestValue_ = 0.0;  ///< of the absolute values
  TransferFunction transfer_;
};

/// Opacity by value: linear between the points, constant outside.
double opacityAt(const TransferFunction& transfer, double value);

/// Colour by value: linear between the points, constant outside.
glm::dvec3 colorAt(const TransferFunction& transfer, double value);

/// The same of the transmission; none without points.
glm::dvec3 transmissionAt(const TransferFunction& transfer, double value);

}  // namespace cdsm::reference
