// SPDX-License-Identifier: Apache-2.0
// Builders of the tiny scenes.
#include "tiny_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/test_scenes.hpp"

namespace cdsm::devices {
namespace {

constexpr int kSide = 16;  ///< pixels and texels

template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

}  // namespace

Scene everythingScene() {
  Scene scene = reference::emptyScene();
  scene.image.width = scene.image.height = kSide;
  scene.shadows.mapSize = kSide;
  scene.camera.position = {0.3f, 1.5f, 4.0f};
  scene.lights.front().cutoff = 25.0f;
  reference::addMesh(scene, reference::stackMesh(1, -1.0f, 1.0f, 2.0f),
                     reference::addMaterial(scene, glm::vec3(0.7f), 1.0f));
  reference::addMesh(scene, reference::stackMesh(1, 1.5f, 1.0f, 0.4f),
                     reference::addMaterial(scene, glm::vec3(0.7f), 0.4f));
  const int glass = reference::addMesh(scene, reference::sphereMesh(0.4f, 8, 4, true),
                                       reference::addMaterial(scene, glm::vec3(0.5f), 0.2f));
  scene.meshes[std::size_t(glass)].interiorExtinction = 1.0f;
  const int volume = reference::addVolume(scene,
                                          reference::makeVolume(VoxelType::UInt8, glm::uvec3(8), glm::vec3(-0.7f),
                                                                glm::vec3(0.7f), reference::gaussianBlob),
                                          reference::linearOpacity(255.0, 0.9f, 0.3f));
  scene.volumes[std::size_t(volume)].specular = glm::vec3(0.4f);
  scene.volumes[std::size_t(volume)].shininess = 12.0f;
  return scene;
}

Scene volumeScene(VoxelType type) {
  Scene scene = reference::emptyScene();
  scene.image.width = scene.image.height = kSide;
  scene.shadows.mapSize = kSide;
  const double largest = reference::largestValue(type);
  reference::addVolume(
      scene, reference::makeVolume(type, {8, 9, 17}, glm::vec3(-0.8f), glm::vec3(0.8f), reference::gaussianBlob),
      reference::linearOpacity(largest, 0.9f, 0.3f));
  return scene;
}

Scene cutScene() {
  Scene scene = volumeScene(VoxelType::UInt8);
  scene.image.width = scene.image.height = scene.shadows.mapSize = 8;  // its shadow rays are slow
  scene.camera.position = {0.0f, 0.1f, 0.5f};
  const int box = reference::addMesh(scene, reference::boxMesh(glm::vec3(-0.6f), glm::vec3(0.6f)),
                                     reference::addMaterial(scene, glm::vec3(1.0f), 0.0f));
  scene.volumes.front().boundary = box;
  return scene;
}

Scene stackScene() {
  Scene scene = reference::emptyScene();
  scene.image.width = scene.image.height = kSide;
  scene.shadows.mapSize = kSide;
  scene.shadows.tolerance = 0.0f;
  reference::addMesh(scene, reference::stackMesh(20, 0.5f, 0.05f, 2.0f),
                     reference::addMaterial(scene, glm::vec3(0.7f), 0.1f));
  return scene;
}

Scene spheresScene() {
  Scene scene = reference::emptyScene();
  scene.image.width = scene.image.height = kSide;
  scene.shadows.mapSize = kSide;
  reference::addMesh(scene, reference::stackMesh(1, -1.0f, 1.0f, 2.0f),
                     reference::addMaterial(scene, glm::vec3(0.7f), 1.0f));
  reference::SphereParts data;
  for (int i = 0; i < 12; ++i) {
    data.centers.emplace_back(0.15f * float(i) - 0.9f, 0.1f * float(i % 5), 0.2f * float(i % 3) - 0.2f);
    data.radii.push_back(0.01f + 0.04f * float(i % 4));
  }
  reference::addSpheres(scene, std::move(data), reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  return scene;
}

Scene along(Scene scene, const std::string& technique, const std::string& memory, const std::string& filter) {
  scene.shadows.technique = technique;
  scene.shadows.memory = memory;
  scene.shadows.filter = filter;
  return scene;
}

Engine engineFor(const std::string& fetch) {
  EngineOptions options;
  options.fetch = fetch;
  return Engine(options);
}

std::string expectSound(Engine& engine, const Scene& scene) {
  const Image image = engine.render(scene);
  EXPECT_EQ(image.pixels.size(), std::size_t(scene.image.width) * scene.image.height);
  for (const glm::vec4& pixel : image.pixels) {
    EXPECT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z)) << pixel.x << " " << pixel.y << " " << pixel.z;
    EXPECT_TRUE(pixel.w >= 0.0f && pixel.w <= 1.0f) << pixel.w;
  }
  std::vector<glm::vec3> points;
  for (int i = 0; i < 10; ++i) points.emplace_back(0.05f * float(i), 1.0f - 0.2f * float(i), -0.03f * float(i));
  std::vector<float> answers;
  for (const Transmittance& t : engine.transmittance(scene, "key", points)) {
    EXPECT_TRUE(t.transmittance >= 0.0f && t.transmittance <= 1.0f) << t.transmittance;
    answers.push_back(t.transmittance);
  }
  return bytesOf(image.pixels) + bytesOf(answers);
}

}  // namespace cdsm::devices
