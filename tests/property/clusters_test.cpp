// SPDX-License-Identifier: Apache-2.0
// Answers and pictures do not depend on clusters: against brute force far outside of the scene, where volumes of
// different clusters overlap, around the light, where a mesh of another cluster cuts a volume; and what pictures leave
// out, nobody misses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cluster/cluster_plan.hpp"
#include "engine_paths.hpp"
#include "frames.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::Random;

constexpr int kMapSize = 96;
constexpr float kTolerance = 0.002f;
constexpr double kSmooth = 0.004;   ///< of the transmittance, to all sides of a point that is asked about
constexpr double kAllowed = 0.015;  ///< and the tolerance, and the engine's coarser step
constexpr double kReach = 0.06;     ///< world units at a distance of 1: two texels of 90 degrees

constexpr double kStep = 0.06;  ///< world units, of brute force: less than a voxel

const std::vector<Path> kPaths{mapPath("chunked", "bilinear", 2), mapPath("atlas", "bilinear", 4),
                               mapPath("chunked", "nearest", 8)};

/// The same transmittance all around a point.
bool isSmooth(const reference::World& world, const Light& light, const glm::dvec3& p, double exact) {
  const bool parallel = light.type == LightType::Directional;
  const double reach = kReach * (parallel ? 1.0 : glm::distance(p, glm::dvec3(light.position)));
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 q = p + 0.7 * reach * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    if (!reference::lit(light, q) || std::abs(transmittance(world, light, q, kStep) - exact) > kSmooth) return false;
  }
  return true;
}

void expectBruteForce(const Scene& scene, const std::vector<glm::vec3>& candidates, std::size_t least) {
  const reference::World world(scene);
  for (const Light& light : scene.lights) {
    std::vector<glm::vec3> points;
    std::vector<double> exact;
    for (const glm::vec3& p : candidates) {
      if (!reference::lit(light, glm::dvec3(p))) continue;
      const double value = transmittance(world, light, glm::dvec3(p), kStep);
      if (!isSmooth(world, light, glm::dvec3(p), value)) continue;
      points.push_back(p);
      exact.push_back(value);
    }
    EXPECT_GE(points.size(), least) << light.name;
    for (const Path& path : kPaths) {
      const auto result = query(path, along(path, scene, kMapSize, kTolerance), points, light.name);
      for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(result[i].transmittance, exact[i], kAllowed)
            << path.name() << ", " << light.name << ", " << points[i].x << " " << points[i].y << " " << points[i].z;
    }
  }
}

/// A wide, soft cloud.
int addCloud(Scene& scene, const glm::vec3& position, float size) {
  return reference::addVolume(
      scene,
      reference::makeVolume(VoxelType::Float32, glm::uvec3(12), glm::vec3(-size), glm::vec3(size),
                            [&](const glm::dvec3& p) { return reference::gaussianBlob(p / double(size)); }),
      reference::linearOpacity(1.0, 0.6f, 0.6f), movedTo(position));
}

/// Lights of all types; the omni light among the objects.
std::vector<Light> allLights() {
  Light spot = reference::keyLight(), omni = spot, sun = spot;
  spot.position = {1.0f, 7.0f, 0.5f};
  spot.cutoff = 30.0f;
  omni.name = "lamp";
  omni.type = LightType::Omni;
  omni.position = {0.15f, 0.3f, 0.1f};
  sun.name = "sun";
  sun.type = LightType::Directional;
  sun.direction = {0.3f, -1.0f, -0.2f};
  return {spot, omni, sun};
}

/// Clouds that overlap, some far apart, and a filled ball around the omni light.
Scene cloudScene() {
  Scene scene = reference::emptyScene();
  scene.lights = allLights();
  scene.shadows.step = 0.02f;
  scene.shadows.clusterDistance = 0.05f;
  for (const glm::vec3& p : {glm::vec3(-1.2f, 0, 0), {-0.7f, 0.1f, 0.3f}, {1.1f, 0.2f, -0.2f}, {0.6f, -0.6f, 0.9f}})
    addCloud(scene, p, 0.9f);
  reference::addMesh(scene, reference::sphereMesh(0.5f, 24, 16, false),
                     reference::addMaterial(scene, glm::vec3(1), 0.2f), movedTo({0.2f, 0.25f, 0.1f}));
  scene.meshes[0].interiorExtinction = 0.8f;
  return scene;
}

std::vector<glm::vec3> pointsWithin(double nearest, double farthest, int count, std::uint32_t seed) {
  Random random(seed);
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(float(random.uniform(nearest, farthest)) * random.direction());
  return points;
}

TEST(Clusters, OfVolumesThatOverlapAndAMediumAroundTheLight) {
  expectBruteForce(cloudScene(), pointsWithin(0.0, 2.5, 60, 1), 8);
}

TEST(Clusters, DoNotMatterFarOutsideOfTheScene) { expectBruteForce(cloudScene(), pointsWithin(4.0, 40.0, 80, 2), 2); }

/// The mesh reaches out of the volume that it cuts, towards the light.
TEST(Clusters, OfAVolumeCutByAMeshOfAnotherCluster) {
  for (const bool meshCasts : {true, false}) {
    Scene scene = reference::emptyScene();
    scene.lights = allLights();
    scene.shadows.step = 0.02f;
    scene.shadows.clusterDistance = 0.01f;
    const int volume = addCloud(scene, {0, 0, 0}, 1.5f);
    const int cut =
        reference::addMesh(scene, reference::boxMesh(glm::vec3(-0.3f, -0.8f, -0.8f), glm::vec3(1.4f, 2.2f, 0.8f)),
                           reference::addMaterial(scene, glm::vec3(1), 0.3f));
    scene.volumes[std::size_t(volume)].boundary = cut;
    scene.meshes[std::size_t(cut)].shadow.casts = meshCasts;
    addCloud(scene, {1.6f, 0.5f, 0.4f}, 0.5f);
    addCloud(scene, {-1.2f, -0.5f, 0.4f}, 0.5f);
    const Path path = mapPath("chunked", "bilinear", 4);
    query(path, along(path, scene, kMapSize, kTolerance), {glm::vec3(0)});
    int together = 0;
    for (const MapStats& map : engineOf("buffer").stats().lights[0].maps)
      together += std::count(map.objects.begin(), map.objects.end(), "volume0") +
                      std::count(map.objects.begin(), map.objects.end(), "mesh0") ==
                  2;
    EXPECT_EQ(together, 0);
    expectBruteForce(scene, pointsWithin(0.0, 2.5, 80, 3), 2);
  }
}

/// Boxes, flat ones too, anywhere around the camera and the light.
Scene boxesScene(Random& random) {
  Scene scene = reference::emptyScene();
  scene.image.width = 36;
  scene.image.height = 24;
  scene.camera.position = 4.0f * random.direction();
  scene.camera.target = 1.5f * random.direction();
  scene.camera.fov = float(random.uniform(15, 70));
  scene.shadows.clusters = 4;
  const int count = random.integer(2, 9);
  for (int i = 0; i < count; ++i) {
    const glm::vec3 half(random.uniform(0.05, 0.8), random.uniform(0.05, 0.8), random.uniform(0.05, 0.8));
    const int material = reference::addMaterial(scene, glm::vec3(0.7f), random.integer(0, 3) ? 1.0f : 0.5f);
    const glm::mat4 pose = movedTo(float(random.uniform(0.0, 3.0)) * random.direction());
    if (random.integer(0, 2))
      reference::addMesh(scene, reference::boxMesh(-half, half), material, pose);
    else
      reference::addMesh(scene, reference::quadMesh(glm::vec3(0), {3.0f * half.x, 0, 0}, {0, 0, 3.0f * half.z}),
                         material, random.integer(0, 1) ? pose : glm::mat4(1.0f));
  }
  Light light = reference::keyLight();
  light.type = LightType(random.integer(0, 2));
  light.position = float(random.uniform(0.5, 6.0)) * random.direction();
  light.target = random.direction();
  light.direction = random.direction();
  light.cutoff = float(random.uniform(8, 60));
  scene.lights = {light};
  return scene;
}

/// Shadow rays, with all objects and without those that pictures leave out.
TEST(Clusters, NobodyMissesWhatPicturesLeaveOut) {
  Random random(5);
  int left = 0, visible = 0;
  for (int i = 0; i < 150; ++i) {
    const Scene scene = along(rayPath(), boxesScene(random), kMapSize, kTolerance);
    Scene clustered = scene;
    clustered.shadows.clusters = 4;
    cluster::KnownShapes known;
    const scene::Bounds bounds = scene::worldBounds(scene);
    const cluster::VisibleSpace space =
        cluster::visibleSpace(scene.camera, double(scene.image.width) / scene.image.height,
                              scene::cameraNearDepth(scene.camera, bounds), bounds);
    const cluster::LightPlan plan = cluster::planLight(clustered, scene.lights[0], cluster::objectShapes(scene, known),
                                                       space, cluster::Purpose::Image);
    if (plan.objects.size() == scene.meshes.size()) continue;
    Scene fewer = scene;
    for (std::size_t k = 0; k < scene.meshes.size(); ++k)
      fewer.meshes[k].shadow.casts = std::count(plan.objects.begin(), plan.objects.end(), unsigned(k)) > 0;
    Scene none = scene;
    none.shadows.technique = "none";
    const Image all = engineOf("buffer").render(scene);
    EXPECT_TRUE(sameBytes(all, engineOf("buffer").render(fewer))) << i;
    visible += !sameBytes(all, engineOf("buffer").render(none));
    left += int(scene.meshes.size() - plan.objects.size());
  }
  EXPECT_GT(left, 80);
  EXPECT_GT(visible, 20);
}

TEST(Clusters, PicturesAreAsWithoutThem) {
  Random random(6);
  for (int i = 0; i < 12; ++i) {
    const Scene scene = boxesScene(random);
    const Image exact = engineOf("buffer").render(along(rayPath(), scene, 256, kTolerance));
    const Image none =
        engineOf("buffer").render(along({"none", "chunked", "bilinear", "buffer"}, scene, 256, kTolerance));
    const double one = rmsDifference(exact, engineOf("buffer").render(along(mapPath(), scene, 256, kTolerance)));
    for (const int clusters : {2, 4}) {
      const Path path = mapPath("chunked", "bilinear", clusters);
      const double error = rmsDifference(exact, engineOf("buffer").render(along(path, scene, 256, kTolerance)));
      EXPECT_LE(error, 1.5 * one + 0.004) << i << ": " << clusters << " clusters";
      EXPECT_LE(error, 0.5 * rmsDifference(exact, none) + 0.01) << i << ": " << clusters << " clusters";
    }
  }
}

}  // namespace
}  // namespace cdsm::property
