// SPDX-License-Identifier: Apache-2.0
#include "given_place.hpp"

#include "reference/test_scenes.hpp"

namespace cdsm::embedding {

cl::Device chosenDevice() {
  const Engine engine;
  const cl_device_id device = opencl::placeOf(engine).device;
  return cl::Device(device, true);
}

VolumeData cloud(VoxelType type, float t) {
  return reference::makeVolume(
      type, {13, 11, 12}, glm::vec3(-0.9f, -0.5f, -0.9f), glm::vec3(0.9f, 0.5f, 0.9f),
      [t](const glm::dvec3& p) { return 0.8 * reference::noise(4.0 * p + glm::dvec3(double(t), 0.3, 0.1)); });
}

Scene cloudScene() {
  Scene scene = reference::emptyScene();
  scene.image.width = 24;
  scene.image.height = 16;
  scene.shadows.mapSize = 32;
  reference::addMesh(scene, reference::quadMesh(glm::vec3(0.0f), {3, 0, 0}, {0, 0, 3}),
                     reference::addMaterial(scene, glm::vec3(0.7f), 1.0f), glm::mat4(1.0f));
  scene.meshes.front().worldFromObject[3].y = -1.0f;
  reference::addVolume(scene, cloud(VoxelType::UInt8), reference::linearOpacity(255.0, 0.9f, 0.2f), glm::mat4(1.0f));
  return scene;
}

Scene sceneOf(const std::shared_ptr<const VolumeData>& data) {
  Scene scene = cloudScene();
  Volume& volume = scene.volumes.front();
  volume.data = data;
  const double largest = reference::largestValue(data->type);
  volume.transfer = reference::linearOpacity(largest, 0.9f, 0.2f);
  return scene;
}

std::vector<glm::vec3> somePoints(std::size_t count) {
  reference::Random random(7);
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(random.uniform(-1.5, 1.5), random.uniform(-1.2, 2.0), random.uniform(-1.5, 1.5));
  return points;
}

std::vector<float> answers(const Scene& scene, const std::vector<glm::vec3>& points) {
  Engine engine;
  engine.prepare(scene);
  return answers(engine, points);
}

std::vector<float> answers(Engine& engine, const std::vector<glm::vec3>& points) {
  std::vector<float> values(points.size(), -2.0f);
  engine.transmittance("key", points.data(), points.size(), values.data());
  return values;
}

std::uint64_t uploaded(const FrameStats& stats, const std::string& what) {
  for (const KernelTime& kernel : stats.kernels)
    if (kernel.name == "upload " + what) return kernel.bytes;
  return 0;
}

}  // namespace cdsm::embedding
