// SPDX-License-Identifier: Apache-2.0
// The objects of a scene that attenuate light, and their shapes as clustering and focusing see them.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <cdsm/scene.hpp>

#include "cluster/convex_body.hpp"

namespace cdsm::cluster {

/// An object in world space. Objects are numbered as on the device: meshes, then volumes.
struct Caster {
  unsigned object = 0;
  double weight = 1.0;
  std::vector<glm::dvec3> corners;    ///< the eight of its oriented box, in the order of ConvexBody::hexahedron
  std::array<glm::dvec3, 3> normals;  ///< of the box's sides, unit
  std::optional<HalfSpace> plane;     ///< that all of a flat mesh lies in; turned to either side
  std::vector<HalfSpace> lid;         ///< of a flat, convex and opaque mesh: planes at its edges, turned inwards
};

/// Boxes and planes of meshes in object space, computed once for each.
class MeshShapes {
 public:
  struct Shape {
    scene::Bounds bounds;
    std::optional<HalfSpace> plane;
    std::vector<glm::dvec3> outline;  ///< corners of a flat mesh that fills their convex hull; else none
  };

  const Shape& of(const std::shared_ptr<const MeshData>& data);
  /// Forgets meshes that the scene no longer has.
  void keepOnly(const Scene& scene);

 private:
  struct Known {
    std::shared_ptr<const MeshData> data;  ///< keeps the address from being used again
    Shape shape;
  };
  std::map<const MeshData*, Known> shapes_;
};

/// True if an object attenuates light at all.
bool casts(const Scene& scene, unsigned object);

/// All objects, whether they cast or not, in the order of their numbers.
std::vector<Caster> objectShapes(const Scene& scene, MeshShapes& shapes);

/// World points whose convex hull contains the object: the vertices of a mesh, the corners of a volume's box.
std::vector<glm::dvec3> hullPoints(const Scene& scene, unsigned object);

}  // namespace cdsm::cluster
