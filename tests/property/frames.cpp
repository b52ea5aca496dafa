// SPDX-License-Identifier: Apache-2.0
#include "frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "reference/test_scenes.hpp"

namespace cdsm::property {

glm::mat4 movedTo(const glm::vec3& position) {
  glm::mat4 matrix(1.0f);
  matrix[3] = glm::vec4(position, 1.0f);
  return matrix;
}

Scene rowScene() {
  Scene scene = reference::emptyScene();
  scene.camera.position = {0.0f, 3.0f, 7.0f};
  scene.image.width = 24;
  scene.image.height = 16;
  const int plain = reference::addMaterial(scene, glm::vec3(0.8f), 1.0f);
  const int glass = reference::addMaterial(scene, glm::vec3(0.5f), 0.5f);
  for (int i = 0; i < 4; ++i)
    reference::addMesh(scene, reference::boxMesh(glm::vec3(-0.2f), glm::vec3(0.2f)), i % 2 ? glass : plain,
                       movedTo({1.2f * float(i) - 2.0f, 0.3f * float(i % 2), i % 2 ? -0.8f : 0.8f}));
  reference::addMesh(scene, reference::quadMesh(glm::vec3(0), {4, 0, 0}, {0, 0, 4}),
                     reference::addMaterial(scene, glm::vec3(0.7f), 1.0f), movedTo({0, -0.6f, 0}));
  reference::addVolume(scene,
                       reference::makeVolume(VoxelType::UInt8, glm::uvec3(12), glm::vec3(-0.4f), glm::vec3(0.4f),
                                             [](const glm::dvec3& p) { return reference::gaussianBlob(2.5 * p); }),
                       reference::linearOpacity(255.0, 0.9f, 0.2f), movedTo({0.1f, 0.7f, 0.0f}));
  scene.lights.front().position = {0.5f, 6.0f, 0.5f};
  scene.lights.front().cutoff = 35.0f;
  return scene;
}

bool sameBytes(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(glm::vec4)) == 0;
}

float largestStep(const Image& a, const Image& b) {
  float largest = a.pixels.size() == b.pixels.size() ? 0.0f : INFINITY;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
    const glm::vec4 step = glm::abs(a.pixels[i] - b.pixels[i]);
    largest = std::max({largest, step.x, step.y, step.z, step.w});
  }
  return largest;
}

double rmsDifference(const Image& a, const Image& b) {
  double sum = a.pixels.size() == b.pixels.size() ? 0.0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
    const glm::dvec4 difference(a.pixels[i] - b.pixels[i]);
    sum += glm::dot(difference, difference);
  }
  return std::sqrt(sum / (4.0 * double(std::max<std::size_t>(a.pixels.size(), 1))));
}

}  // namespace cdsm::property
