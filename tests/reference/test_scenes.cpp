// SPDX-License-Identifier: Apache-2.0
// Whole scenes of the tests: the empty one to add to, and random ones.
#include "test_scenes.hpp"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace cdsm::reference {
namespace {

glm::mat4 rotation(const glm::vec3& axis, double angle) {
  const auto c = static_cast<float>(std::cos(angle));
  const auto s = static_cast<float>(std::sin(angle));
  const glm::mat3 cross(0.0f, axis.z, -axis.y, -axis.z, 0.0f, axis.x, axis.y, -axis.x, 0.0f);
  return glm::mat4(glm::mat3(1.0f) + s * cross + (1.0f - c) * cross * cross);
}

/// A rotation, then a move by up to `reach` per axis.
glm::mat4 randomPose(Random& random, double reach) {
  glm::mat4 pose = rotation(random.direction(), random.uniform(0.0, 6.28));
  for (int axis = 0; axis < 3; ++axis) pose[3][axis] = static_cast<float>(random.uniform(-reach, reach));
  return pose;
}

/// Scale and shear of the unit frame, determinant far from 0.
glm::mat4 randomStretch(Random& random) {
  glm::mat4 stretch(1.0f);
  for (int axis = 0; axis < 3; ++axis) stretch[axis][axis] = static_cast<float>(random.uniform(0.5, 0.9));
  stretch[1][0] = static_cast<float>(random.uniform(-0.3, 0.3));
  stretch[2][1] = static_cast<float>(random.uniform(-0.3, 0.3));
  return stretch;
}

/// A soft ramp, and in one of two cases a peak of a few percent of the range on top of it.
TransferFunction randomTransfer(Random& random, double largest) {
  TransferFunction transfer;
  transfer.unitDistance = static_cast<float>(random.uniform(0.2, 1.0));
  const auto add = [&](double value, double opacity) {
    transfer.opacity.push_back({static_cast<float>(value * largest), static_cast<float>(opacity)});
  };
  add(random.uniform(0.0, 0.2), 0.0);
  if (random.integer(0, 1) == 1) {
    const double peak = random.uniform(0.3, 0.5);
    add(peak - 0.03, 0.05);
    add(peak, random.uniform(0.3, 0.9));
    add(peak + 0.03, 0.05);
  }
  add(random.uniform(0.6, 1.0), random.uniform(0.1, 0.6));
  transfer.color.push_back({0.0f, glm::vec3(0.2f, 0.4f, 0.9f)});
  transfer.color.push_back({static_cast<float>(largest), glm::vec3(1.0f, 0.8f, 0.5f)});
  return transfer;
}

void addRandomVolume(Scene& scene, Random& random) {
  const VoxelType types[3] = {VoxelType::UInt8, VoxelType::Int16, VoxelType::Float32};
  const VoxelType type = types[random.integer(0, 2)];
  const glm::uvec3 size(random.integer(8, 16), random.integer(8, 16), random.integer(8, 16));
  const glm::dvec3 offset(random.uniform(0.0, 50.0), random.uniform(0.0, 50.0), random.uniform(0.0, 50.0));
  const Field field = [&](const glm::dvec3& p) { return noise(1.5 * p + offset); };
  addVolume(scene, makeVolume(type, size, glm::vec3(-1.0f), glm::vec3(1.0f), field),
            randomTransfer(random, largestValue(type)), randomPose(random, 0.5) * randomStretch(random));
}

void addRandomSphere(Scene& scene, Random& random, float opacity) {
  const auto radius = static_cast<float>(random.uniform(0.25, 0.6));
  const int mesh = addMesh(scene, sphereMesh(radius, 12, 8, false), addMaterial(scene, glm::vec3(0.7f), opacity),
                           randomPose(random, 0.8));
  scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction = static_cast<float>(random.uniform(0.2, 2.0));
}

void addRandomQuad(Scene& scene, Random& random, float opacity) {
  const auto half = static_cast<float>(random.uniform(0.2, 0.5));
  addMesh(scene, quadMesh(glm::vec3(0.0f), {half, 0.0f, 0.0f}, {0.0f, 0.0f, half}),
          addMaterial(scene, glm::vec3(0.7f), opacity), randomPose(random, 0.8));
}

void addRandomMesh(Scene& scene, Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return addRandomQuad(scene, random, 1.0f);
    case 1:
      return addRandomQuad(scene, random, static_cast<float>(random.uniform(0.2, 0.8)));
    case 2:
      return addRandomSphere(scene, random, 0.0f);
    default:
      return addRandomSphere(scene, random, static_cast<float>(random.uniform(0.1, 0.5)));
  }
}

/// In one of three scenes an invisible box cuts the first volume.
void addRandomBoundary(Scene& scene, Random& random) {
  if (random.integer(0, 2) != 0) return;
  scene.volumes.front().boundary = addMesh(scene, boxMesh(glm::vec3(-0.6f), glm::vec3(0.6f)),
                                           addMaterial(scene, glm::vec3(1.0f), 0.0f), randomPose(random, 0.4));
}

void addRandomLights(Scene& scene, Random& random) {
  scene.lights.clear();
  const int count = random.integer(1, 2);
  for (int i = 0; i < count; ++i) {
    Light light;
    light.name = i == 0 ? "key" : "fill";
    light.position = static_cast<float>(random.uniform(5.0, 7.0)) * random.direction();
    light.target = 0.2f * random.direction();
    light.cutoff = static_cast<float>(random.uniform(12.0, 25.0));
    scene.lights.push_back(light);
  }
}

}  // namespace

glm::vec3 Random::direction() {
  const double y = uniform(-1.0, 1.0);
  const double angle = uniform(0.0, 6.283185307179586);
  const double r = std::sqrt(1.0 - y * y);
  return glm::vec3(glm::dvec3(r * std::cos(angle), y, r * std::sin(angle)));
}

Light keyLight() {
  Light light;
  light.name = "key";
  light.position = {0.0f, 4.0f, 0.0f};
  light.target = glm::vec3(0.0f);
  light.cutoff = 20.0f;
  return light;
}

Scene emptyScene() {
  Scene scene;
  scene.camera.position = {0.0f, 1.0f, 6.0f};
  scene.image.width = 48;
  scene.image.height = 32;
  scene.lights.push_back(keyLight());
  return scene;
}

int addMaterial(Scene& scene, const glm::vec3& diffuse, float opacity) {
  Material material;
  material.name = "material" + std::to_string(scene.materials.size());
  material.diffuse = diffuse;
  material.opacity = opacity;
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

int addMesh(Scene& scene, MeshData data, int material, const glm::mat4& worldFromObject) {
  Mesh mesh;
  mesh.name = "mesh" + std::to_string(scene.meshes.size());
  mesh.data = std::make_shared<const MeshData>(std::move(data));
  mesh.material = material;
  mesh.worldFromObject = worldFromObject;
  scene.meshes.push_back(mesh);
  return static_cast<int>(scene.meshes.size()) - 1;
}

int addSpheres(Scene& scene, SphereData data, int material, const glm::mat4& worldFromObject) {
  Spheres spheres;
  spheres.name = "spheres" + std::to_string(scene.spheres.size());
  spheres.data = std::make_shared<const SphereData>(std::move(data));
  spheres.material = material;
  spheres.worldFromObject = worldFromObject;
  scene.spheres.push_back(spheres);
  return static_cast<int>(scene.spheres.size()) - 1;
}

int addVolume(Scene& scene, VolumeData data, const TransferFunction& transfer, const glm::mat4& worldFromObject) {
  Volume volume;
  volume.name = "volume" + std::to_string(scene.volumes.size());
  volume.data = std::make_shared<const VolumeData>(std::move(data));
  volume.transfer = transfer;
  volume.worldFromObject = worldFromObject;
  scene.volumes.push_back(volume);
  return static_cast<int>(scene.volumes.size()) - 1;
}

TransferFunction constantOpacity(float opacity, float unitDistance) {
  TransferFunction transfer;
  transfer.opacity = {{0.0f, opacity}, {1.0f, opacity}};
  transfer.color = {{0.0f, glm::vec3(1.0f)}, {1.0f, glm::vec3(1.0f)}};
  transfer.unitDistance = unitDistance;
  return transfer;
}

TransferFunction linearOpacity(double value, float opacity, float unitDistance) {
  TransferFunction transfer = constantOpacity(0.0f, unitDistance);
  transfer.opacity = {{0.0f, 0.0f}, {static_cast<float>(value), opacity}};
  return transfer;
}

void giveRandomRoles(Scene& scene, std::uint32_t seed) {
  Random random(seed + 3000u);
  const auto give = [&](ShadowRole& role) {
    role.casts = random.integer(0, 1) == 1;
    role.receives = random.integer(0, 1) == 1;
  };
  for (Mesh& mesh : scene.meshes) give(mesh.shadow);
  for (Volume& volume : scene.volumes) give(volume.shadow);
  for (Spheres& spheres : scene.spheres) give(spheres.shadow);
}

void giveRandomTransmissions(Scene& scene, std::uint32_t seed) {
  Random random(seed + 4000u);
  const auto color = [&random] {
    glm::vec3 c;
    for (int channel = 0; channel < 3; ++channel) c[channel] = static_cast<float>(random.uniform(0.0, 1.0));
    return c;
  };
  scene.shadows.transmittance = "rgb";
  for (Material& material : scene.materials) material.transmission = color();
  for (Mesh& mesh : scene.meshes) mesh.interiorTransmission = color();
  for (Volume& volume : scene.volumes) {
    const auto largest = static_cast<float>(largestValue(volume.data->type));
    volume.transfer.transmission = {{0.0f, color()}, {0.4f * largest, color()}, {largest, color()}};
  }
}

void addRandomSpheres(Scene& scene, std::uint32_t seed) {
  Random random(seed + 4000u);
  for (const bool opaque : {true, false}) {
    SphereParts data;
    const int count = random.integer(3, 12);
    for (int i = 0; i < count; ++i) {
      data.centers.push_back(static_cast<float>(random.uniform(0.3, 1.2)) * random.direction());
      data.radii.push_back(static_cast<float>(random.uniform(0.05, 0.35)));
      const double red = random.uniform(0.0, 1.0), green = random.uniform(0.0, 1.0);
      if (!opaque) data.colors.emplace_back(red, green, random.uniform(0.0, 1.0));
    }
    const float opacity = opaque ? 1.0f : static_cast<float>(random.uniform(0.2, 0.7));
    const auto scale = static_cast<float>(random.uniform(0.7, 1.3));
    const auto turn = static_cast<float>(random.uniform(0.0, 6.0));
    const glm::mat4 pose = glm::scale(glm::rotate(glm::mat4(1.0f), turn, random.direction()), glm::vec3(scale));
    addSpheres(scene, std::move(data), addMaterial(scene, {0.8f, 0.5f, 0.3f}, opacity), pose);
  }
}

std::vector<Light> otherLights(std::uint32_t seed) {
  Random random(seed + 2000u);
  Light omni, directional;
  omni.name = "key";
  omni.type = LightType::Omni;
  omni.position = static_cast<float>(random.uniform(0.5, 1.2)) * random.direction();
  directional.name = "fill";
  directional.type = LightType::Directional;
  directional.direction = static_cast<float>(random.uniform(0.5, 3.0)) * random.direction();
  return {omni, directional};
}

Scene randomScene(std::uint32_t seed) {
  Random random(seed);
  Scene scene = emptyScene();
  const int volumes = random.integer(1, 3);
  for (int i = 0; i < volumes; ++i) addRandomVolume(scene, random);
  const int meshes = random.integer(1, 4);
  for (int i = 0; i < meshes; ++i) addRandomMesh(scene, random);
  addRandomBoundary(scene, random);
  addRandomLights(scene, random);
  return scene;
}

}  // namespace cdsm::reference
