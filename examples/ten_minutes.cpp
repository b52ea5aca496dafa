// SPDX-License-Identifier: Apache-2.0
// What docs/embedding.md shows, as a program: a scene from arrays, light at points, an image, a time step. Exit status
// 0 if all of it is as it should be.
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace {

cdsm::Volume makeVolume(const std::vector<float>& voxels) {
  auto data = std::make_shared<cdsm::VolumeData>();
  data->type = cdsm::VoxelType::Float32;
  data->size = {32, 32, 32};
  data->view.data = voxels.data();  // stays ours: read in place where the device shares the host's memory
  for (int axis = 0; axis < 3; ++axis) data->objectFromIndex[axis][axis] = 2.0f / 32.0f;
  data->objectFromIndex[3] = {-0.96875f, -0.96875f, -0.96875f, 1.0f};  // of the first voxel's centre

  cdsm::Volume volume;
  volume.name = "cloud";
  volume.data = data;
  volume.transfer.opacity = {{0.0f, 0.0f}, {1.0f, 0.8f}};  // value, opacity
  volume.transfer.color = {{0.0f, {1.0f, 0.9f, 0.8f}}};
  volume.transfer.unitDistance = 0.5f;  // world units for which the opacities hold
  return volume;
}

struct Vertex {
  float position[3], uv[2];
};
const Vertex kFloor[] = {
    {{-3.0f, -1.2f, -3.0f}, {}}, {{-3.0f, -1.2f, 3.0f}, {}}, {{3.0f, -1.2f, 3.0f}, {}}, {{3.0f, -1.2f, -3.0f}, {}}};

cdsm::Mesh makeFloor() {
  auto data = std::make_shared<cdsm::MeshData>();
  data->positions = cdsm::Array<glm::vec3>::view(kFloor, 4, sizeof(Vertex));  // stay ours: read where they are
  data->triangles = {{0, 1, 2}, {0, 2, 3}};                                   // an array of its own

  cdsm::Mesh mesh;
  mesh.name = "floor";
  mesh.data = data;
  mesh.material = 0;  // of the scene's
  return mesh;
}

cdsm::Scene makeScene(const std::vector<float>& voxels) {
  cdsm::Scene scene;
  scene.camera.position = {0.0f, 1.5f, 5.0f};
  scene.image.width = 180;
  scene.image.height = 120;
  scene.materials.resize(1);
  scene.meshes = {makeFloor()};
  scene.volumes = {makeVolume(voxels)};
  scene.lights.resize(1);
  scene.lights[0].name = "lamp";
  scene.lights[0].position = {0.0f, 4.0f, 0.0f};
  return scene;
}

/// A ball of fog.
std::vector<float> ball(float radius) {
  std::vector<float> voxels;
  for (int i = 0; i < 32 * 32 * 32; ++i) {
    const glm::vec3 at = (glm::vec3(i % 32, i / 32 % 32, i / 1024) - 15.5f) / 16.0f;
    voxels.push_back(std::max(0.0f, 1.0f - glm::length(at) / radius));
  }
  return voxels;
}

int run() {
  std::vector<float> voxels = ball(0.5f);
  cdsm::Scene scene = makeScene(voxels);

  cdsm::EngineOptions options;
  options.warning = [](const std::string& text) { std::printf("warning: %s\n", text.c_str()); };
  cdsm::Engine engine(options);

  engine.prepare(scene);
  const std::vector<glm::vec3> points = {{0.0f, 2.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {9.0f, 0.0f, 0.0f}};
  std::vector<float> light(points.size());
  engine.transmittance("lamp", points.data(), points.size(), light.data());
  std::printf("above %.3f, below %.3f, outside of the cone %.0f\n", light[0], light[1], light[2]);
  const float before = light[1];
  if (light[0] != 1.0f || before <= 0.0f || before >= 0.9f || light[2] != -1.0f) return 1;

  const cdsm::Image image = engine.render(scene);
  std::printf("%d x %d pixels in %.0f ms\n", image.width, image.height, engine.stats().totalMs);

  const std::vector<float> next = ball(0.9f);
  std::copy(next.begin(), next.end(), voxels.begin());
  ++scene.volumes[0].revision;  // the same memory, other values
  engine.prepare(scene);
  engine.transmittance("lamp", points.data(), points.size(), light.data());
  std::printf("a time step later %.3f below; %llu bytes were copied\n", light[1],
              static_cast<unsigned long long>(engine.stats().copiedBytes));
  return light[1] < before ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const cdsm::Error& error) {
    std::printf("error: %s\n", error.what());
    return 1;
  }
}
