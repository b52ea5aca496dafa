// SPDX-License-Identifier: Apache-2.0
#include "technique/shadow_rays.hpp"

#include <cstring>

#include "scene/objects.hpp"
#include "scene/view.hpp"
#include "technique/bvh.hpp"

namespace cdsm::technique {

namespace {

float dotPoint(const shared::float4& row, const glm::vec3& p) {
  return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
}

shared::float4 worldPoint(const shared::Affine& m, const glm::vec3& p) {
  return {dotPoint(m.x, p), dotPoint(m.y, p), dotPoint(m.z, p), 0.0f};
}

/// The bits of a number as a float.
float bitsOf(unsigned number) {
  float bits;
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

/// Per mesh, whether rays have to meet it: where its surface or its interior casts, or a volume that it cuts.
std::vector<bool> metMeshes(const Scene& scene) {
  std::vector<bool> met;
  for (const Mesh& mesh : scene.meshes) {
    const bool attenuates =
        scene.materials[std::size_t(mesh.material)].opacity > 0.0f || mesh.interiorExtinction > 0.0f;
    met.push_back(mesh.shadow.casts && attenuates);
  }
  for (const Volume& volume : scene.volumes)
    if (volume.boundary >= 0 && volume.shadow.casts) met[std::size_t(volume.boundary)] = true;
  return met;
}

/// The triangles of an object in world space.
void addTriangles(const build::ObjectTriangles& triangles, const shared::Affine& worldFromObject, unsigned object,
                  std::vector<shared::BvhPrimitive>& primitives) {
  const MeshData& data = *triangles.data;
  const auto corner = [&](unsigned vertex) { return worldPoint(worldFromObject, data.positions[vertex]); };
  for (const glm::uvec3& t : data.triangles) {
    shared::BvhPrimitive triangle{corner(t.x), corner(triangles.flip ? t.z : t.y), corner(triangles.flip ? t.y : t.z)};
    triangle.a.w = bitsOf(object);
    primitives.push_back(triangle);
  }
}

/// The spheres of an object in world space.
void addSpheres(const Spheres& spheres, unsigned object, std::vector<shared::BvhPrimitive>& primitives) {
  const float scale = scene::scaleOf(spheres.worldFromObject), bits = bitsOf(object);
  const SphereData& data = *spheres.data;
  for (std::size_t i = 0; i < data.centers.size(); ++i) {
    const glm::vec3 center(spheres.worldFromObject * glm::vec4(data.centers[i], 1.0f));
    primitives.push_back({{center, bits}, {glm::vec3(0.0f), scale * data.radii[i]}, {}});
  }
}

/// All that casts, but the volumes, whose boxes are met by formula.
std::vector<shared::BvhPrimitive> primitivesOf(const Scene& scene, const build::DeviceScene& deviceScene) {
  std::vector<shared::BvhPrimitive> primitives;
  const std::vector<bool> met = metMeshes(scene);
  for (unsigned i = 0; i < met.size(); ++i) {  // objects of the same numbers
    if (!met[i]) continue;
    addTriangles(deviceScene.geometry().objects()[i], deviceScene.hostObjects()[i].worldFromObject, i, primitives);
  }
  auto object = unsigned(scene::firstSpheres(scene));
  for (const Spheres& spheres : scene.spheres) {
    if (spheres.shadow.casts && scene.materials[std::size_t(spheres.material)].opacity > 0.0f)
      addSpheres(spheres, object, primitives);
    ++object;
  }
  return primitives;
}

}  // namespace

void ShadowRays::buildHierarchy(const Scene& scene, const build::DeviceScene& deviceScene) {
  const Bvh bvh = buildBvh(primitivesOf(scene, deviceScene));
  nodes_ = device::Buffer<shared::BvhNode>::fromHost(device_, bvh.nodes, "hierarchy of triangles and spheres");
  primitives_ = device::Buffer<shared::BvhPrimitive>::fromHost(device_, bvh.primitives, "primitives of shadow rays");
  const auto mediumObjects = deviceScene.objectsOfMedia();
  mediumCount_ = mediumObjects.size();
  mediumObjects_ = device::Buffer<std::uint32_t>::fromHost(device_, mediumObjects, "objects of media");
}

void ShadowRays::prepare(const Preparation& to) {
  if (to.objectsChanged) buildHierarchy(to.scene, to.deviceScene);
  std::vector<std::uint32_t> objects;
  around_.clear();
  for (const Light& light : to.scene.lights) {
    std::vector<std::uint32_t> around;  // none: parallel light starts in front of everything
    if (light.type != LightType::Directional)
      around = to.deviceScene.objectsAround(to.deviceScene.allObjects().enclosing, light.position);
    around_.push_back({shared::uint(objects.size()), shared::uint(around.size())});
    objects.insert(objects.end(), around.begin(), around.end());
  }
  opaqueExtinctions_ = device::Buffer<float>::fromHost(
      device_, to.deviceScene.opaqueExtinctions(to.scene.shadows.threshold), "opaque extinctions");
  lightExtinctions_ = to.deviceScene.lightExtinctions().cl();
  lightObjects_ = device::Buffer<std::uint32_t>::fromHost(device_, objects, "objects around lights");
}

void ShadowRays::describeLight(std::size_t light, shared::LightData& data) const {
  data.firstMap = around_[light].x;
  data.mapCount = around_[light].y;
}

shared::TechniqueParams ShadowRays::params(const Scene& scene) const {
  shared::TechniqueParams params{};
  params.mediumCount = shared::uint(mediumCount_);
  params.nodeCount = shared::uint(nodes_.size());
  params.opaque = scene.shadows.rays == "opaque";
  params.threshold = scene.shadows.threshold;
  return params;
}

device::ArgumentList ShadowRays::arguments() const {
  return {nodes_.cl(),         primitives_.cl(),        lightObjects_.cl(),
          mediumObjects_.cl(), opaqueExtinctions_.cl(), lightExtinctions_};
}

}  // namespace cdsm::technique
