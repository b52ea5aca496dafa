// SPDX-License-Identifier: Apache-2.0
// Convex bodies as lists of polygons, in double precision [Knecht 2011, Alg. 4.3].
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scene/view.hpp"

namespace cdsm::cluster {

/// Points p with dot(normal, p) + offset >= 0 lie inside.
struct HalfSpace {
  glm::dvec3 normal{0.0};  ///< unit
  double offset = 0.0;

  double distance(const glm::dvec3& p) const { return glm::dot(normal, p) + offset; }
};

/// The half space of a plane through `point`; `normal` of any length, it points inside.
HalfSpace halfSpace(const glm::dvec3& normal, const glm::dvec3& point);

/// Corners of the convex hull of points in a plane with this normal; none if they lie in one line.
std::vector<glm::dvec3> hullInPlane(const std::vector<glm::dvec3>& points, const glm::dvec3& normal);

/// A closed convex body. Clipping may leave nothing: then it has no polygons.
class ConvexBody {
 public:
  using Polygon = std::vector<glm::dvec3>;

  ConvexBody() = default;

  /// The hexahedron of eight corners: bit 0 of a corner's number is x, bit 1 y, bit 2 z.
  static ConvexBody hexahedron(const std::vector<glm::dvec3>& corners);
  static ConvexBody box(const scene::Bounds& bounds);

  bool empty() const { return polygons_.empty(); }
  const std::vector<Polygon>& polygons() const { return polygons_; }
  std::vector<glm::dvec3> vertices() const;

  /// The planes of the polygons, turned inwards.
  std::vector<HalfSpace> halfSpaces() const;

  /// Hull of the body and a point [Knecht 2011, Alg. 4.3, lines 2-8].
  ConvexBody hullWith(const glm::dvec3& point) const;
  /// The body drawn along a vector: hull of the body and the same body moved by it.
  ConvexBody sweptAlong(const glm::dvec3& way) const;

  /// What of the body lies in the half space; the cut is closed with the convex hull of its corners [Knecht 2011,
  /// §4.5].
  void clip(const HalfSpace& inside);
  void clip(const std::vector<HalfSpace>& inside);

  /// False only if the body and the hull of `points` certainly have nothing in common: a plane of the body, or an axis
  /// of `axes`, separates them.
  bool mayTouch(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& axes) const;

 private:
  std::vector<Polygon> polygons_;
};

}  // namespace cdsm::cluster
