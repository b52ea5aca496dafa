// SPDX-License-Identifier: Apache-2.0
// Builders of the image tests' scenes: every kind of object and shading at least once.
#include "image_scenes.hpp"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "reference/test_scenes.hpp"

namespace cdsm::images {
namespace {

using namespace reference;

glm::mat4 moved(float x, float y, float z) {
  glm::mat4 result(1.0f);
  result[3] = {x, y, z, 1.0f};
  return result;
}

/// The empty scene seen from above, with a grey floor at y = -1 and a light from the side.
Scene floorScene() {
  Scene scene = emptyScene();
  scene.camera.position = {0.5f, 2.0f, 4.5f};
  scene.image.background = {0.1f, 0.2f, 0.3f};
  Light& light = scene.lights.front();
  light.position = {2.0f, 4.0f, 1.5f};
  light.cutoff = 30.0f;
  addMesh(scene, stackMesh(1, -1.0f, 1.0f, 2.5f), addMaterial(scene, glm::vec3(0.7f), 1.0f));
  return scene;
}

Scene smokeOverFloor() {
  Scene scene = floorScene();
  TransferFunction transfer = linearOpacity(255.0, 0.9f, 0.2f);
  transfer.color = {{0.0f, glm::vec3(1.0f, 0.9f, 0.7f)}, {255.0f, glm::vec3(0.5f, 0.6f, 1.0f)}};
  const int volume =
      addVolume(scene, makeVolume(VoxelType::UInt8, glm::uvec3(20), glm::vec3(-1), glm::vec3(1), smoke), transfer);
  scene.volumes[static_cast<std::size_t>(volume)].shading = false;
  return scene;
}

Scene spheresUnderSheet() {
  Scene scene = floorScene();
  const int shiny = addMaterial(scene, {0.8f, 0.4f, 0.2f}, 1.0f);
  scene.materials[static_cast<std::size_t>(shiny)].specular = glm::vec3(0.4f);
  scene.materials[static_cast<std::size_t>(shiny)].shininess = 20.0f;
  addMesh(scene, sphereMesh(0.5f, 32, 16, true), shiny, moved(-0.6f, -0.4f, 0.3f));
  addMesh(scene, sphereMesh(0.4f, 12, 6, false), addMaterial(scene, {0.3f, 0.7f, 0.4f}, 0.5f),
          moved(0.7f, -0.5f, 0.2f));
  addMesh(scene, quadMesh({0.3f, 0.6f, 0.0f}, {0.7f, 0.0f, 0.0f}, {0.0f, 0.1f, 0.6f}),
          addMaterial(scene, {0.6f, 0.8f, 1.0f}, 0.3f));
  return scene;
}

Scene shadedVolumes() {
  Scene scene = floorScene();
  Light fill = keyLight();
  fill.name = "fill";
  fill.position = {-3.0f, 2.5f, 2.0f};
  fill.color = {0.3f, 0.4f, 0.5f};
  scene.lights.push_back(fill);
  TransferFunction transfer = linearOpacity(1.0, 0.9f, 0.4f);
  transfer.color = {{0.0f, glm::vec3(0.9f, 0.3f, 0.2f)}, {1.0f, glm::vec3(1.0f, 0.9f, 0.4f)}};
  const int blob = addVolume(
      scene, makeVolume(VoxelType::Float32, {16, 18, 14}, glm::vec3(-1), glm::vec3(1), gaussianBlob), transfer);
  scene.volumes[static_cast<std::size_t>(blob)].specular = glm::vec3(0.3f);
  scene.volumes[static_cast<std::size_t>(blob)].shininess = 10.0f;
  addVolume(scene, makeVolume(VoxelType::Int16, glm::uvec3(12), glm::vec3(-1), glm::vec3(1), gaussianBlob),
            linearOpacity(32767.0, 0.7f, 0.5f), moved(0.8f, 0.1f, 0.3f));
  return scene;
}

Scene mediumAndCut() {
  Scene scene = floorScene();
  const int glass = addMesh(scene, sphereMesh(0.6f, 24, 12, true), addMaterial(scene, {0.9f, 0.9f, 1.0f}, 0.15f),
                            moved(-0.8f, -0.2f, 0.2f));
  scene.meshes[static_cast<std::size_t>(glass)].interiorExtinction = 1.5f;
  scene.meshes[static_cast<std::size_t>(glass)].interiorColor = {0.9f, 0.5f, 0.3f};
  const int cut =
      addMesh(scene, boxMesh({0.1f, -0.6f, -0.5f}, {1.2f, 0.3f, 0.6f}), addMaterial(scene, glm::vec3(1.0f), 0.0f));
  const int volume =
      addVolume(scene, makeVolume(VoxelType::UInt8, glm::uvec3(16), glm::vec3(-1), glm::vec3(1), gaussianBlob),
                linearOpacity(255.0, 0.8f, 0.4f), moved(0.6f, -0.1f, 0.0f));
  scene.volumes[static_cast<std::size_t>(volume)].boundary = cut;
  scene.volumes[static_cast<std::size_t>(volume)].shading = false;
  return scene;
}

/// A lamp between smoke and spheres, a spot from the side, sunlight from behind.
Scene threeKindsOfLights() {
  Scene scene = smokeOverFloor();
  scene.volumes.front().shading = true;
  scene.volumes.front().specular = glm::vec3(0.2f);
  scene.volumes.front().shininess = 8.0f;
  scene.volumes.front().worldFromObject = moved(-0.4f, 0.0f, 0.0f);
  const int shiny = addMaterial(scene, {0.8f, 0.4f, 0.2f}, 1.0f);
  scene.materials[static_cast<std::size_t>(shiny)].specular = glm::vec3(0.4f);
  scene.materials[static_cast<std::size_t>(shiny)].shininess = 20.0f;
  addMesh(scene, sphereMesh(0.4f, 32, 16, true), shiny, moved(1.0f, -0.4f, 0.3f));
  addMesh(scene, sphereMesh(0.3f, 24, 12, true), addMaterial(scene, {0.4f, 0.6f, 0.9f}, 0.4f),
          moved(0.3f, -0.5f, 1.2f));
  scene.lights.front().color = glm::vec3(0.4f);
  Light lamp, sun;
  lamp.name = "lamp";
  lamp.type = LightType::Omni;
  lamp.position = {0.35f, 0.1f, 0.4f};
  lamp.color = {0.6f, 0.5f, 0.4f};
  sun.name = "sun";
  sun.type = LightType::Directional;
  sun.direction = {1.0f, -2.0f, 1.2f};
  sun.color = {0.3f, 0.35f, 0.4f};
  scene.lights.insert(scene.lights.end(), {lamp, sun});
  return scene;
}

/// Untessellated spheres, opaque and translucent, in smoke and in front of a mesh.
Scene balls() {
  Scene scene = smokeOverFloor();
  scene.volumes.front().worldFromObject = moved(-0.9f, 0.1f, -0.2f);
  const int shiny = addMaterial(scene, {0.8f, 0.4f, 0.2f}, 1.0f);
  scene.materials[static_cast<std::size_t>(shiny)].specular = glm::vec3(0.4f);
  scene.materials[static_cast<std::size_t>(shiny)].shininess = 20.0f;
  SphereData opaque{{{-0.8f, -0.2f, 0.3f}, {0.1f, -0.7f, 0.8f}, {0.6f, 0.6f, -0.4f}}, {0.4f, 0.3f, 0.35f}, {}};
  SphereData clear{{{0.7f, -0.5f, 0.4f}, {1.0f, 0.1f, 0.2f}, {0.2f, 0.2f, 0.5f}}, {0.45f, 0.3f, 0.25f}, {}};
  clear.colors = {{0.2f, 0.7f, 0.9f}, {0.9f, 0.8f, 0.2f}, {0.5f, 0.9f, 0.4f}};
  addSpheres(scene, opaque, shiny);
  addSpheres(scene, clear, addMaterial(scene, glm::vec3(1.0f), 0.4f), glm::scale(glm::mat4(1.0f), glm::vec3(1.1f)));
  addMesh(scene, quadMesh({1.0f, -0.3f, -1.0f}, {0.7f, 0.0f, 0.0f}, {0.0f, 0.6f, 0.1f}),
          addMaterial(scene, {0.6f, 0.8f, 1.0f}, 0.6f));
  Light sun;
  sun.name = "sun";
  sun.type = LightType::Directional;
  sun.direction = {1.0f, -2.0f, -0.6f};
  sun.color = glm::vec3(0.4f);
  scene.lights.front().color = glm::vec3(0.6f);
  scene.lights.push_back(sun);
  return scene;
}

/// Light is coloured by what it gets through.
ImageScene inColor(ImageScene scene, std::uint32_t seed) {
  giveRandomTransmissions(scene.scene, seed);
  scene.scene.materials.front().transmission = glm::vec3(0.0f);  // of the floor
  scene.name += "InColor";
  return scene;
}

/// Some objects are lit as if nothing stood in the way.
ImageScene someReceive(ImageScene scene, std::uint32_t seed) {
  giveRandomRoles(scene.scene, seed);
  for (Mesh& mesh : scene.scene.meshes) mesh.shadow.casts = true;
  for (Volume& volume : scene.scene.volumes) volume.shadow.casts = true;
  for (Spheres& spheres : scene.scene.spheres) spheres.shadow.casts = true;
  scene.name += "SomeReceive";
  return scene;
}

ImageScene someCast(ImageScene scene, std::uint32_t seed) {
  giveRandomRoles(scene.scene, seed);
  scene.name += "SomeCast";
  return scene;
}

}  // namespace

std::vector<ImageScene> imageScenes() {
  std::vector<ImageScene> scenes{
      {"SmokeOverFloor", smokeOverFloor()},         {"SpheresUnderSheet", spheresUnderSheet()},
      {"ShadedVolumes", shadedVolumes()},           {"MediumAndCut", mediumAndCut()},
      {"ThreeKindsOfLights", threeKindsOfLights()}, {"Balls", balls()}};
  struct Seeds {
    std::size_t scene;
    std::uint32_t receive, cast;
  };
  // chosen so that floors are shadowed, and not by all that is above them
  for (const Seeds& seeds : {Seeds{1, 2, 16}, Seeds{2, 2, 4}, Seeds{3, 3, 6}, Seeds{4, 8, 10}, Seeds{5, 3, 5}}) {
    scenes.push_back(someReceive(scenes[seeds.scene], seeds.receive));
    scenes.push_back(someCast(scenes[seeds.scene], seeds.cast));
  }
  for (const std::size_t scene : {3u, 5u}) scenes.push_back(inColor(scenes[scene], 2));
  return scenes;
}

}  // namespace cdsm::images
