// SPDX-License-Identifier: Apache-2.0
// In: triangles and rays in world space, double precision. Out: every crossing of a ray with a mesh, once each.
#pragma once

#include <vector>

#include <cdsm/scene.hpp>
#include <glm/glm.hpp>

namespace cdsm::reference {

/// World space; `direction` has length 1, so t is a world length.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
  glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The ray from one point towards another.
Ray rayTowards(const glm::dvec3& from, const glm::dvec3& to);

struct Crossing {
  double t;            ///< > 0
  int mesh;            ///< index into Scene::meshes
  int triangle;        ///< index into MeshData::triangles
  glm::dvec3 weights;  ///< barycentric, of the triangle's three corners
  int sign;            ///< +1 where the ray enters a mesh with outward normals, -1 where it leaves
};

/// A mesh of the scene in world space.
class Surface {
 public:
  explicit Surface(const Mesh& mesh);

  /// Appends all crossings with t > 0. A ray through a shared edge or vertex crosses a closed surface exactly as often
  /// as a ray infinitesimally beside it: no gaps, nothing counted twice.
  void addCrossings(const Ray& ray, int meshIndex, std::vector<Crossing>& crossings) const;

  /// Unit normal for shading: interpolated if the mesh has normals, else that of the triangle.
  glm::dvec3 normal(const Crossing& crossing) const;

 private:
  std::vector<glm::dvec3> positions_;
  std::vector<glm::dvec3> normals_;  ///< empty, or one per position; not of unit length
  std::vector<glm::uvec3> triangles_;
};

/// How often the surface of `mesh` winds around the ray's point at t; `crossings` are all those of the ray with t > 0,
/// also beyond the point of interest. Not zero: inside. The ray may start inside.
int windingNumber(const std::vector<Crossing>& crossings, int mesh, double t);

}  // namespace cdsm::reference
