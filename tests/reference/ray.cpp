// SPDX-License-Identifier: Apache-2.0
// Crossings by projecting the triangles along the ray: edge functions with a fixed order of the two ends and a symbolic
// shift of the ray make the decision at shared edges the same for both triangles.
#include "ray.hpp"

#include <array>
#include <cmath>

namespace cdsm::reference {
namespace {

using Corner = glm::dvec3;  ///< x, y: across the ray, which runs through 0, 0; z: along it

/// Twice the area of the triangle (a, b, ray), exactly antisymmetric in a and b even where the compiler fuses products.
double edgeFunction(const Corner& a, const Corner& b) {
  const bool ordered = a.x < b.x || (a.x == b.x && a.y < b.y);
  const Corner& p = ordered ? a : b;
  const Corner& q = ordered ? b : a;
  const double area = p.x * q.y - p.y * q.x;
  return ordered ? area : -area;
}

/// The side of the edge the ray is on: +1, -1, or 0 for an edge without length. A ray on the edge is thought of as
/// shifted by (e, e * e) with e -> 0.
int sideOf(const Corner& a, const Corner& b, double edge) {
  if (edge != 0.0) return edge > 0.0 ? 1 : -1;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  if (a.x != b.x) return b.x > a.x ? 1 : -1;
  return 0;
}

struct Basis {
  glm::dvec3 right, up;
};

/// right, up and the direction are right-handed.
Basis basisAround(const glm::dvec3& direction) {
  const glm::dvec3 hint = std::abs(direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(hint, direction));
  return {right, glm::cross(direction, right)};
}

}  // namespace

Ray rayTowards(const glm::dvec3& from, const glm::dvec3& to) { return {from, glm::normalize(to - from)}; }

Surface::Surface(const Mesh& mesh) : triangles_(mesh.data->triangles.begin(), mesh.data->triangles.end()) {
  const glm::dmat4 worldFromObject(mesh.worldFromObject);
  const glm::dmat3 normalFromObject = glm::transpose(glm::inverse(glm::dmat3(worldFromObject)));
  for (const glm::vec3& p : mesh.data->positions) {
    positions_.push_back(glm::dvec3(worldFromObject * glm::dvec4(glm::dvec3(p), 1.0)));
  }
  for (const glm::vec3& n : mesh.data->normals) normals_.push_back(normalFromObject * glm::dvec3(n));
}

void Surface::addCrossings(const Ray& ray, int meshIndex, std::vector<Crossing>& crossings) const {
  const Basis basis = basisAround(ray.direction);
  std::vector<Corner> corners;
  corners.reserve(positions_.size());
  for (const glm::dvec3& position : positions_) {
    const glm::dvec3 p = position - ray.origin;
    corners.emplace_back(glm::dot(p, basis.right), glm::dot(p, basis.up), glm::dot(p, ray.direction));
  }
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Corner& a = corners[triangles_[i].x];
    const Corner& b = corners[triangles_[i].y];
    const Corner& c = corners[triangles_[i].z];
    const glm::dvec3 edges(edgeFunction(b, c), edgeFunction(c, a), edgeFunction(a, b));
    const int side = sideOf(b, c, edges.x);
    if (side == 0 || sideOf(c, a, edges.y) != side || sideOf(a, b, edges.z) != side) continue;
    const double area = edges.x + edges.y + edges.z;
    if (area == 0.0) continue;
    const glm::dvec3 weights = edges / area;
    const double t = glm::dot(weights, glm::dvec3(a.z, b.z, c.z));
    // Counter-clockwise as seen along the ray: the normal points along it, the ray leaves.
    if (t > 0.0) crossings.push_back({t, meshIndex, static_cast<int>(i), weights, -side});
  }
}

glm::dvec3 Surface::normal(const Crossing& crossing) const {
  const glm::uvec3& t = triangles_[static_cast<std::size_t>(crossing.triangle)];
  if (!normals_.empty()) {
    const glm::dvec3& w = crossing.weights;
    return glm::normalize(w.x * normals_[t.x] + w.y * normals_[t.y] + w.z * normals_[t.z]);
  }
  return glm::normalize(glm::cross(positions_[t.y] - positions_[t.x], positions_[t.z] - positions_[t.x]));
}

Balls::Balls(const Spheres& spheres) {
  const glm::dmat4 worldFromObject(spheres.worldFromObject);
  const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromObject))));
  for (const glm::vec3& center : spheres.data->centers)
    centers_.push_back(glm::dvec3(worldFromObject * glm::dvec4(glm::dvec3(center), 1.0)));
  for (const float radius : spheres.data->radii) radii_.push_back(scale * static_cast<double>(radius));
}

void Balls::addCrossings(const Ray& ray, int spheresIndex, std::vector<Crossing>& crossings) const {
  for (std::size_t i = 0; i < centers_.size(); ++i) {
    // t^2 - 2 b t + c = 0
    const glm::dvec3 way = centers_[i] - ray.origin;
    const double b = glm::dot(way, ray.direction), c = glm::dot(way, way) - radii_[i] * radii_[i];
    if (b * b < c) continue;
    const double root = std::sqrt(b * b - c);
    for (const int sign : {1, -1}) {
      const double t = b - sign * root;
      if (t > 0.0) crossings.push_back({t, -1, -1, {}, sign, spheresIndex, static_cast<int>(i)});
    }
  }
}

glm::dvec3 Balls::normal(const Crossing& crossing, const glm::dvec3& point) const {
  return glm::normalize(point - centers_[static_cast<std::size_t>(crossing.sphere)]);
}

int windingNumber(const std::vector<Crossing>& crossings, int mesh, double t) {
  int winding = 0;
  for (const Crossing& crossing : crossings) {
    // Far away the number is 0, so what lies behind t undoes what holds at t.
    if (crossing.mesh == mesh && crossing.t > t) winding -= crossing.sign;
  }
  return winding;
}

}  // namespace cdsm::reference
