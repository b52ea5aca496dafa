// SPDX-License-Identifier: Apache-2.0
// In: triangles, spheres and rays in world space, double precision. Out: every crossing of a ray with a mesh or a
// sphere, once each.
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
  int mesh;            ///< index into Scene::meshes; -1: of a sphere
  int triangle;        ///< index into MeshData::triangles
  glm::dvec3 weights;  ///< barycentric, of the triangle's three corners
  int sign;            ///< +1 where the ray enters a mesh with outward normals, or a sphere, -1 where it leaves
  int spheres = -1;    ///< index into Scene::spheres
  int sphere = -1;     ///< index into SphereData::centers
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

/// Spheres of the scene in world space.
class Balls {
 public:
  explicit Balls(const Spheres& spheres);

  /// Appends all crossings with t > 0.
  void addCrossings(const Ray& ray, int spheresIndex, std::vector<Crossing>& crossings) const;

  /// Unit, outwards.
  glm::dvec3 normal(const Crossing& crossing, const glm::dvec3& point) const;

 private:
  std::vector<glm::dvec3> centers_;
  std::vector<double> radii_;
};

/// How often the surface of `mesh` winds around the ray's point at t; `crossings` are all those of the ray with t > 0,
/// also beyond the point of interest. Not zero: inside. The ray may start inside.
int windingNumber(const std::vector<Crossing>& crossings, int mesh, double t);

}  // namespace cdsm::reference
