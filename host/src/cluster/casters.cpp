// SPDX-License-Identifier: Apache-2.0
#include "cluster/casters.hpp"

#include <algorithm>

#include "scene/objects.hpp"

namespace cdsm::cluster {

namespace {

/// Vertices nearer to a plane than this part of the mesh's size lie in it.
constexpr double kFlatPart = 1e-6;

/// The plane of the largest triangle, if all vertices lie in it.
std::optional<HalfSpace> planeOf(const MeshData& data, double size) {
  glm::dvec3 normal(0.0), point(0.0);
  for (const glm::uvec3& t : data.triangles) {
    const glm::dvec3 a(data.positions[t.x]), b(data.positions[t.y]), c(data.positions[t.z]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    if (glm::dot(n, n) <= glm::dot(normal, normal)) continue;
    normal = n;
    point = a;
  }
  if (glm::dot(normal, normal) <= 0.0) return std::nullopt;
  const HalfSpace plane = halfSpace(normal, point);
  const bool flat = std::all_of(data.positions.begin(), data.positions.end(), [&](const glm::vec3& p) {
    return std::abs(plane.distance(glm::dvec3(p))) <= kFlatPart * size;
  });
  return flat ? std::optional(plane) : std::nullopt;
}

/// The convex hull of a flat mesh, if its triangles fill it exactly once.
std::vector<glm::dvec3> filledOutline(const MeshData& data, const glm::dvec3& normal) {
  std::vector<glm::dvec3> points(data.positions.begin(), data.positions.end());
  const std::vector<glm::dvec3> hull = hullInPlane(points, normal);
  double area = 0.0, filled = 0.0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i)
    area += glm::length(glm::cross(hull[i] - hull[0], hull[i + 1] - hull[0]));
  for (const glm::uvec3& t : data.triangles) {
    const glm::dvec3 a(data.positions[t.x]);
    filled += glm::length(glm::cross(glm::dvec3(data.positions[t.y]) - a, glm::dvec3(data.positions[t.z]) - a));
  }
  return std::abs(area - filled) <= kFlatPart * area ? hull : std::vector<glm::dvec3>{};
}

/// Planes through the edges of a polygon at right angles to it, turned to its middle.
std::vector<HalfSpace> edgePlanes(const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal) {
  std::vector<HalfSpace> planes;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : polygon) middle += p / double(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    HalfSpace plane = halfSpace(glm::cross(normal, edge), polygon[i]);
    if (plane.distance(middle) < 0.0) plane = {-plane.normal, -plane.offset};
    planes.push_back(plane);
  }
  return planes;
}

std::vector<glm::dvec3> boxCorners(const scene::Bounds& bounds, const glm::dmat4& worldFromBox) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 unit(i & 1, i >> 1 & 1, i >> 2);
    corners.emplace_back(worldFromBox *
                         glm::dvec4(glm::mix(glm::dvec3(bounds.low), glm::dvec3(bounds.high), unit), 1.0));
  }
  return corners;
}

scene::Bounds indexBounds(const Volume& volume) { return {glm::vec3(-0.5f), glm::vec3(volume.data->size) - 0.5f}; }

/// Rows of the inverse are the normals of a box's sides.
std::array<glm::dvec3, 3> sideNormals(const glm::dmat4& worldFromBox) {
  const glm::dmat3 boxFromWorld = glm::inverse(glm::dmat3(worldFromBox));
  std::array<glm::dvec3, 3> normals;
  for (int i = 0; i < 3; ++i)
    normals[i] = glm::normalize(glm::dvec3(boxFromWorld[0][i], boxFromWorld[1][i], boxFromWorld[2][i]));
  return normals;
}

Caster meshShape(const Mesh& mesh, const KnownShapes::Shape& shape, bool opaque) {
  Caster caster;
  const glm::dmat4 matrix(mesh.worldFromObject);
  caster.weight = mesh.shadow.weight;
  caster.corners = boxCorners(shape.bounds, matrix);
  caster.normals = sideNormals(matrix);
  if (shape.plane) {
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(glm::dmat3(matrix)));
    const glm::dvec3 foot = -shape.plane->offset * shape.plane->normal;
    caster.plane = halfSpace(normalMatrix * shape.plane->normal, glm::dvec3(matrix * glm::dvec4(foot, 1.0)));
    std::vector<glm::dvec3> outline;
    for (const glm::dvec3& p : shape.outline) outline.emplace_back(matrix * glm::dvec4(p, 1.0));
    if (opaque) caster.lid = edgePlanes(outline, caster.plane->normal);
  }
  return caster;
}

/// Corners of a body with 26 sides around all spheres: those of their box, its edges and corners cut off.
std::vector<glm::dvec3> hullOf(const SphereData& data, const scene::Bounds& bounds) {
  ConvexBody body = ConvexBody::box(bounds);
  for (int direction = 0; direction < 27; ++direction) {
    const glm::dvec3 way(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
    if (glm::dot(way, way) < 1.5) continue;  // the box's own sides
    const glm::dvec3 outwards = glm::normalize(way);
    double farthest = -INFINITY;
    for (std::size_t i = 0; i < data.centers.size(); ++i)
      farthest = std::max(farthest, glm::dot(outwards, glm::dvec3(data.centers[i])) + double(data.radii[i]));
    body.clip({-outwards, farthest});
  }
  return body.vertices();
}

Caster spheresShape(const Spheres& spheres, const KnownShapes::Shape& shape) {
  Caster caster;
  const glm::dmat4 matrix(spheres.worldFromObject);
  caster.weight = spheres.shadow.weight;
  caster.corners = boxCorners(shape.bounds, matrix);
  caster.normals = sideNormals(matrix);
  for (const glm::dvec3& p : shape.hull) caster.hull.emplace_back(matrix * glm::dvec4(p, 1.0));
  return caster;
}

KnownShapes::Shape shapeOf(const MeshData& data) {
  KnownShapes::Shape shape;
  shape.bounds = scene::boundsOf(data, glm::mat4(1.0f));
  if (data.positions.empty()) shape.bounds.add(glm::vec3(0.0f));
  shape.plane = planeOf(data, shape.bounds.diagonal());
  if (shape.plane) shape.outline = filledOutline(data, shape.plane->normal);
  return shape;
}

KnownShapes::Shape shapeOf(const SphereData& data) {
  KnownShapes::Shape shape;
  shape.bounds = scene::boundsOf(data, glm::mat4(1.0f));
  shape.hull = hullOf(data, shape.bounds);
  return shape;
}

Caster volumeShape(const Volume& volume) {
  Caster caster;
  const glm::dmat4 matrix(scene::worldFromIndex(volume));
  caster.weight = volume.shadow.weight;
  caster.corners = boxCorners(indexBounds(volume), matrix);
  caster.normals = sideNormals(matrix);
  return caster;
}

}  // namespace

const KnownShapes::Shape& KnownShapes::of(const Mesh& mesh) {
  const auto [entry, isNew] = shapes_.try_emplace({mesh.data, mesh.revision});
  return isNew ? entry->second = shapeOf(*mesh.data) : entry->second;
}

const KnownShapes::Shape& KnownShapes::of(const Spheres& spheres) {
  const auto [entry, isNew] = shapes_.try_emplace({spheres.data, spheres.revision});
  return isNew ? entry->second = shapeOf(*spheres.data) : entry->second;
}

void KnownShapes::keepOnly(const Scene& scene) {
  const auto usedBy = [](const auto& objects, const Key& key) {
    return std::any_of(objects.begin(), objects.end(),
                       [&](const auto& object) { return object.data == key.first && object.revision == key.second; });
  };
  for (auto entry = shapes_.begin(); entry != shapes_.end();) {
    const bool used = usedBy(scene.meshes, entry->first) || usedBy(scene.spheres, entry->first);
    entry = used ? std::next(entry) : shapes_.erase(entry);
  }
}

bool casts(const Scene& scene, unsigned object) {
  const scene::ObjectPlace place = scene::placeOf(scene, object);
  if (place.kind == scene::ObjectKind::Mesh) {
    const Mesh& mesh = scene.meshes[place.index];
    return mesh.shadow.casts && !mesh.data->triangles.empty() &&
           (scene.materials[mesh.material].opacity > 0.0f || mesh.interiorExtinction > 0.0f);
  }
  if (place.kind == scene::ObjectKind::Spheres) {
    const Spheres& spheres = scene.spheres[place.index];
    return spheres.shadow.casts && scene.materials[spheres.material].opacity > 0.0f;
  }
  const Volume& volume = scene.volumes[place.index];
  const auto& curve = volume.transfer.towardsLights();
  return volume.shadow.casts && std::any_of(curve.begin(), curve.end(), [](const auto& p) { return p.opacity > 0.0f; });
}

std::vector<Caster> objectShapes(const Scene& scene, KnownShapes& shapes) {
  std::vector<Caster> list;
  for (const Mesh& mesh : scene.meshes)
    list.push_back(meshShape(mesh, shapes.of(mesh), scene.materials[mesh.material].opacity >= 1.0f));
  for (const Volume& volume : scene.volumes) list.push_back(volumeShape(volume));
  for (const Spheres& spheres : scene.spheres) list.push_back(spheresShape(spheres, shapes.of(spheres)));
  for (std::size_t i = 0; i < list.size(); ++i) list[i].object = unsigned(i);
  return list;
}

std::vector<glm::dvec3> hullPoints(const Scene& scene, const Caster& shape) {
  if (shape.object >= scene.meshes.size()) return shape.hull.empty() ? shape.corners : shape.hull;
  std::vector<glm::dvec3> points;
  const Mesh& mesh = scene.meshes[shape.object];
  for (const glm::vec3& p : mesh.data->positions) points.emplace_back(mesh.worldFromObject * glm::vec4(p, 1.0f));
  return points;
}

}  // namespace cdsm::cluster
