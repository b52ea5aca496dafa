// SPDX-License-Identifier: Apache-2.0
// Omni and directional lights: no seams between the maps of an omni light, lights do not mix, statistics of their maps.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine_paths.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 96;
constexpr float kTolerance = 0.002f;

/// Soft volumes, thin sheets of surface nowhere: what is seen at a seam is the seam's.
Scene softScene() {
  Scene scene = reference::emptyScene();
  for (const float x : {-0.6f, 0.0f, 0.7f}) {
    glm::mat4 move(1.0f);
    move[3] = {x, 0.4f * x, 0.3f - x * x, 1.0f};
    reference::addVolume(scene,
                         reference::makeVolume(VoxelType::Float32, glm::uvec3(16), glm::vec3(-1.5f), glm::vec3(1.5f),
                                               reference::gaussianBlob),
                         reference::linearOpacity(1.0, 0.7f, 0.5f), move);
  }
  scene.lights.front().type = LightType::Omni;
  scene.lights.front().position = {0.2f, 0.1f, -0.15f};
  return scene;
}

/// Pairs of points on both sides of the twelve borders between maps, close enough to be the same point to a map.
std::vector<glm::vec3> acrossBorders(const glm::vec3& light) {
  std::vector<glm::vec3> points;
  reference::Random random(4);
  for (int i = 0; i < 600; ++i) {
    const int first = random.integer(0, 2), second = (first + random.integer(1, 2)) % 3;
    glm::vec3 way;
    for (int axis = 0; axis < 3; ++axis) way[axis] = static_cast<float>(random.uniform(-1.0, 1.0));
    const float sign[2] = {random.integer(0, 1) ? 1.0f : -1.0f, random.integer(0, 1) ? 1.0f : -1.0f};
    const auto distance = static_cast<float>(random.uniform(0.1, 2.0));
    for (const float side : {-1e-4f, 1e-4f}) {
      way[first] = sign[0];
      way[second] = sign[1] * (1.0f + side);
      points.push_back(light + distance * way);
    }
  }
  return points;
}

TEST(Omni, hasNoSeamsBetweenItsMaps) {
  const Scene scene = softScene();
  const std::vector<glm::vec3> points = acrossBorders(scene.lights.front().position);
  const reference::World world(scene);
  for (const char* memory : {"chunked", "atlas", "exact", "tiled"}) {
    const Path path = mapPath(memory);
    const std::vector<Transmittance> result = query(path, along(path, scene, kMapSize, kTolerance), points);
    double largest = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < result.size(); i += 2) {
      const double jump = std::abs(double(result[i].transmittance) - result[i + 1].transmittance);
      largest = std::max(largest, jump);
      sum += jump;
      EXPECT_NEAR(result[i].transmittance, transmittance(world, scene.lights.front(), glm::dvec3(points[i])), 8e-3);
    }
    EXPECT_LE(largest, 2.0 * double(kTolerance)) << memory;
    EXPECT_LE(sum / (0.5 * double(result.size())), 0.5 * double(kTolerance)) << memory;
  }
}

Scene mixedScene() {
  Scene scene = reference::randomScene(2);
  std::vector<Light> lights = reference::otherLights(2);
  lights[0].name = "lamp";
  lights[1].name = "sun";
  scene.lights.insert(scene.lights.begin(), lights[0]);
  scene.lights.push_back(lights[1]);
  lights[0].name = "second lamp";
  lights[0].position = {-0.3f, 0.9f, 0.4f};
  scene.lights.push_back(lights[0]);
  return scene;
}

TEST(Lights, ofAllTypesDoNotMix) {
  const Scene mixed = mixedScene();
  reference::Random random(9);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 500; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 2.5)) * random.direction());
  for (const Path& path : {mapPath("chunked"), mapPath("atlas"), mapPath("exact"), mapPath("tiled"), rayPath()}) {
    for (const Light& light : mixed.lights) {
      Scene alone = mixed;
      alone.lights = {light};
      EXPECT_LE(largestDifference(query(path, along(path, mixed, kMapSize, kTolerance), points, light.name),
                                  query(path, along(path, alone, kMapSize, kTolerance), points, light.name)),
                1e-5)
          << path.name() << ", " << light.name;
    }
  }
}

TEST(Lights, areReportedWithTheirMaps) {
  const Scene scene = along(mapPath(), mixedScene(), kMapSize, kTolerance);
  query(mapPath(), scene, {glm::vec3(0.0f)}, "sun");
  const std::vector<LightStats>& lights = engineOf("buffer").stats().lights;
  ASSERT_EQ(lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const LightType type = scene.lights[i].type;
    EXPECT_EQ(lights[i].type, type == LightType::Omni ? "omni" : type == LightType::Spot ? "spot" : "directional");
    EXPECT_EQ(lights[i].maps.size(), type == LightType::Omni ? 6u : 1u);
    for (const MapStats& map : lights[i].maps) {
      EXPECT_LT(map.nearDepth, map.farDepth);
      EXPECT_EQ(map.objects.size(), scene.meshes.size() + scene.volumes.size());
      if (type == LightType::Directional) EXPECT_EQ(map.fovX, 0.0);
      if (type == LightType::Omni) EXPECT_NEAR(map.fovX, 91.2, 0.1);  // 90 and a texel of 96 on each side
    }
  }
}

TEST(Lights, anotherDirectionIsAnotherScene) {
  Scene scene = reference::emptyScene();
  reference::addMesh(scene, reference::stackMesh(1, 0.0f, 1.0f, 1.0f), reference::addMaterial(scene, glm::vec3(1), 1));
  scene.lights.front().type = LightType::Directional;
  for (const Path& path : {mapPath(), rayPath()}) {
    for (const float y : {-1.0f, 1.0f}) {
      scene.lights.front().direction = {0.1f, y, 0.0f};
      const auto result = query(path, along(path, scene, kMapSize, kTolerance), {{0, -1, 0}, {0, 1, 0}, {9, 9, 9}});
      EXPECT_EQ(result[0].transmittance, y < 0 ? 0.0f : 1.0f) << path.name();
      EXPECT_EQ(result[1].transmittance, y < 0 ? 1.0f : 0.0f) << path.name();
      EXPECT_EQ(result[2].transmittance, 1.0f) << path.name();
      EXPECT_EQ(result[2].lit, 1);
    }
  }
}

}  // namespace
}  // namespace cdsm::property
