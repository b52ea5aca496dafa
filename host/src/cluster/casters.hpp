// SPDX-License-Identifier: Apache-2.0
// The objects of a scene that attenuate light, and their shapes as clustering and focusing see them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <cdsm/scene.hpp>

#include "cluster/convex_body.hpp"

namespace cdsm::cluster {

/// An object in world space, with its number in the scene.
struct Caster {
  unsigned object = 0;
  double weight = 1.0;
  std::vector<glm::dvec3> corners;    ///< the eight of its oriented box, in the order of ConvexBody::hexahedron
  std::array<glm::dvec3, 3> normals;  ///< of the box's sides, unit
  std::optional<HalfSpace> plane;     ///< that all of a flat mesh lies in; turned to either side
  std::vector<glm::dvec3> hull;       ///< of spheres: corners of a convex body around them
  std::vector<HalfSpace> lid;         ///< of a flat, convex and opaque mesh: planes at its edges, turned inwards
};

/// Boxes, planes and hulls of meshes and spheres in object space, computed once for each.
class KnownShapes {
 public:
  struct Shape {
    scene::Bounds bounds;
    std::optional<HalfSpace> plane;
    std::vector<glm::dvec3> outline;  ///< corners of a flat mesh that fills their convex hull; else none
    std::vector<glm::dvec3> hull;     ///< of spheres
  };

  const Shape& of(const Mesh& mesh);
  const Shape& of(const Spheres& spheres);
  /// Forgets data, and revisions of them, that the scene no longer has.
  void keepOnly(const Scene& scene);

 private:
  using Key = std::pair<std::shared_ptr<const void>, std::uint64_t>;  ///< data and their revision

  std::map<Key, Shape> shapes_;
};

/// True if an object attenuates light at all.
bool casts(const Scene& scene, unsigned object);

/// All objects, whether they cast or not, in the order of their numbers.
std::vector<Caster> objectShapes(const Scene& scene, KnownShapes& shapes);

/// World points whose convex hull contains the object: the vertices of a mesh, the corners of a volume's box, those of
/// a body around spheres.
std::vector<glm::dvec3> hullPoints(const Scene& scene, const Caster& shape);

}  // namespace cdsm::cluster
