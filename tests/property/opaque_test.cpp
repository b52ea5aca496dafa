// SPDX-License-Identifier: Apache-2.0
// Techniques that know all or nothing, opaque rays and shadow maps: against brute force with the same threshold, closed
// forms on either side of it, and deep shadow maps where nothing is translucent.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::World;

constexpr int kMapSize = 512;
constexpr float kTolerance = 0.005f;

struct OpaquePath {
  const char* name;
  const char* technique;
  const char* filter;
  int pcf;
};

/// Texels to all sides that the widest of the filters reaches, and one for the point's place in its own.
constexpr double kReach = 2.0;

const std::vector<OpaquePath> kPaths{{"Rays", "shadow-rays", "bilinear", 1},
                                     {"Map", "shadow-map", "bilinear", 0},
                                     {"MapNearest", "shadow-map", "nearest", 1},
                                     {"MapBilinear", "shadow-map", "bilinear", 1}};

Scene opaque(const OpaquePath& path, const Scene& scene, double threshold) {
  Scene result = along({path.technique, "chunked", path.filter, "buffer"}, scene, kMapSize, kTolerance);
  result.shadows.rays = "opaque";
  result.shadows.pcf = path.pcf;
  result.shadows.threshold = float(threshold);
  return result;
}

std::vector<float> answers(const OpaquePath& path, const Scene& scene, double threshold,
                           const std::vector<glm::vec3>& points, const std::string& light = "key") {
  std::vector<float> values;
  for (const Transmittance& t : query(rayPath(), opaque(path, scene, threshold), points, light))
    values.push_back(t.transmittance);
  return values;
}

/// A sample just over the threshold may be alone, and steps from elsewhere miss it.
constexpr double kMargin = 0.04;

/// The same answer as far as the filter reaches, nearer and farther, with the engine's step and thresholds near by.
bool isClear(const World& world, const Light& light, const glm::dvec3& point, double threshold, double exact) {
  const LightFrame frame(world.scene, light, kMapSize, point);
  const glm::dvec3 at = frame.coordinates(point);
  const double reach = kReach * frame.texel(), deeper = std::max(kReach * frame.texelAt(at.z), 0.1);
  const auto same = [&](const glm::dvec3& p, double step) {
    return reference::lit(light, p) && opaqueTransmittance(world, light, p, threshold - kMargin, step) == exact &&
           opaqueTransmittance(world, light, p, threshold + kMargin, step) == exact;
  };
  for (int dx = -2; dx <= 2; ++dx)
    for (int dy = -2; dy <= 2; ++dy)
      if (!same(frame.point(at.x + 0.5 * dx * reach, at.y + 0.5 * dy * reach, at.z), reference::kEngineStep))
        return false;
  return same(frame.point(at.x, at.y, at.z - deeper), reference::kFineStep) &&
         same(frame.point(at.x, at.y, at.z + deeper), reference::kFineStep) && same(point, reference::kFineStep);
}

/// Random scenes by every path at points away from the borders of shadows.
void expectBruteForce(const World& world, const Light& light, std::uint32_t seed, double threshold) {
  reference::Random random(seed + 2000u);
  std::vector<glm::vec3> points;
  std::vector<double> exact;
  for (int i = 0; i < 120; ++i) {
    const glm::vec3 point = static_cast<float>(random.uniform(0.0, 1.8)) * random.direction();
    const double value = opaqueTransmittance(world, light, glm::dvec3(point), threshold);
    if (!reference::lit(light, glm::dvec3(point)) || !isClear(world, light, glm::dvec3(point), threshold, value))
      continue;
    points.push_back(point);
    exact.push_back(value);
  }
  const auto dark = std::count(exact.begin(), exact.end(), 0.0);
  std::cout << "light " << light.name << ": " << points.size() << " points kept, " << dark << " of them dark\n";
  EXPECT_GE(points.size(), 20u);
  for (const OpaquePath& path : kPaths) {
    const std::vector<float> result = answers(path, world.scene, threshold, points, light.name);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(result[i], exact[i], 1e-6) << path.name << ", light " << light.name << ", point " << points[i].x
                                             << " " << points[i].y << " " << points[i].z;
  }
}

class OpaqueScenes : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(OpaqueScenes, agreeWithBruteForce) {
  Scene scene = reference::randomScene(GetParam());
  scene.shadows.step = 0.01f;  // shells of transfer functions may be thinner than half a voxel
  if (GetParam() % 2 == 0) scene.lights = reference::otherLights(GetParam());
  if (GetParam() % 3 == 0) reference::giveRandomRoles(scene, GetParam());
  for (const double threshold : {0.15, 0.45}) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", threshold " + std::to_string(threshold));
    for (const Light& light : scene.lights) expectBruteForce(scene, light, GetParam(), threshold);
  }
}

TEST_P(OpaqueScenes, agreeWithBruteForceWithSpheres) {
  Scene scene = reference::randomScene(GetParam());
  reference::addRandomSpheres(scene, GetParam());
  scene.shadows.step = 0.01f;
  if (GetParam() % 2 == 0) scene.lights = reference::otherLights(GetParam());
  for (const Light& light : scene.lights) expectBruteForce(scene, light, GetParam(), 0.35);
}

/// What is dark over a higher threshold is dark over a lower one.
TEST_P(OpaqueScenes, getDarkerWithALowerThreshold) {
  const Scene scene = reference::randomScene(GetParam());
  reference::Random random(GetParam() + 3000u);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 2000; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 2.0)) * random.direction());
  const std::string light = scene.lights.front().name;
  for (const OpaquePath& path : kPaths) {
    std::vector<float> before(points.size(), 0.0f);
    for (const double threshold : {0.0, 0.1, 0.3, 0.5, 0.8, 0.99}) {
      const std::vector<float> now = answers(path, scene, threshold, points, light);
      std::size_t fallen = 0;
      for (std::size_t i = 0; i < points.size(); ++i) fallen += now[i] < before[i];
      EXPECT_EQ(fallen, 0u) << path.name << ", threshold " << threshold;
      before = now;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OpaqueScenes, ::testing::Range<std::uint32_t>(1, 4));

/// A slab from -0.5 to 0.5, in the way of all light to (0.1, -1, 0.1).
enum class Slab { Volume, Interior, Sheet };

Scene slabScene(Slab slab, float opacity, float unitDistance) {
  Scene scene = reference::emptyScene();
  const bool filled = slab == Slab::Interior;
  if (slab == Slab::Volume)
    reference::addVolume(scene,
                         reference::makeVolume(VoxelType::UInt8, glm::uvec3(16), {-2, -0.5f, -2}, {2, 0.5f, 2},
                                               [](const glm::dvec3&) { return 1.0; }),
                         reference::constantOpacity(opacity, unitDistance));
  else
    reference::addMesh(scene, reference::boxMesh({-2, -0.5f, -2}, {2, 0.5f, 2}),
                       reference::addMaterial(scene, glm::vec3(0.5f), filled ? 0.0f : opacity));
  if (filled) scene.meshes.front().interiorExtinction = -std::log1p(-opacity);
  return scene;
}

class OpaqueSlabs : public ::testing::TestWithParam<Slab> {};

/// Whatever the steps and, of volumes, the unit: opacity is per unit distance.
TEST_P(OpaqueSlabs, stopLightIfTheirOpacityIsOverTheThreshold) {
  const std::vector<glm::vec3> points{{0.1f, 1.0f, 0.1f}, {0.1f, 0.6f, 0.0f}, {0.1f, -1.0f, 0.1f}, {0.0f, 0.0f, 0.1f}};
  for (const OpaquePath& path : kPaths)
    for (const float unitDistance : {0.01f, 1.0f, 30.0f})
      for (const float step : {0.0f, 0.4f}) {
        Scene scene = slabScene(GetParam(), 0.4f, unitDistance);
        scene.shadows.step = step;
        EXPECT_EQ(answers(path, scene, 0.39, points), (std::vector<float>{1, 1, 0, 0})) << path.name;
        EXPECT_EQ(answers(path, scene, 0.41, points), (std::vector<float>{1, 1, 1, 1})) << path.name;
      }
}

/// Of a volume and of a surface the threshold's own opacity lets all light pass.
TEST_P(OpaqueSlabs, letLightPassAtTheThresholdItself) {
  if (GetParam() == Slab::Interior) GTEST_SKIP() << "its opacity is a rounded exponential";
  for (const OpaquePath& path : kPaths)
    for (const float opacity : {0.25f, 0.5f, 0.9f})
      EXPECT_EQ(answers(path, slabScene(GetParam(), opacity, 0.7f), double(opacity), {{0.1f, -1.0f, 0.1f}}),
                std::vector<float>{1.0f})
          << path.name << ", opacity " << opacity;
}

TEST_P(OpaqueSlabs, castNoShadowIfTheyAreToldSo) {
  Scene scene = slabScene(GetParam(), 0.9f, 1.0f);
  for (Mesh& mesh : scene.meshes) mesh.shadow.casts = false;
  for (Volume& volume : scene.volumes) volume.shadow.casts = false;
  for (const OpaquePath& path : kPaths)
    EXPECT_EQ(answers(path, scene, 0.0, {{0.1f, -1.0f, 0.1f}}), std::vector<float>{1.0f}) << path.name;
}

/// Light inside of what stops it reaches nothing.
TEST_P(OpaqueSlabs, stopTheLightInside) {
  Scene scene = slabScene(GetParam(), 0.9f, 1.0f);
  scene.lights.front().position = {0.0f, 0.2f, 0.0f};
  for (const OpaquePath& path : kPaths)
    EXPECT_EQ(answers(path, scene, 0.5, {{0.02f, -1.0f, 0.02f}}), std::vector<float>{0.0f}) << path.name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, OpaqueSlabs, ::testing::Values(Slab::Volume, Slab::Interior, Slab::Sheet));

/// Opaque meshes alone: there is nothing that deep shadow maps know better.
TEST(ShadowMap, isTheDeepShadowMapOfOpaqueScenes) {
  Scene scene = reference::emptyScene();
  const int material = reference::addMaterial(scene, glm::vec3(0.7f), 1.0f);
  reference::addMesh(scene, reference::sphereMesh(0.6f, 24, 12, true), material);
  reference::addMesh(scene, reference::quadMesh({0.5f, -0.7f, 0.2f}, {0.5f, 0.1f, 0.0f}, {0.0f, 0.2f, 0.6f}), material);
  reference::addMesh(scene, reference::stackMesh(1, -1.2f, 1.0f, 2.0f), material);
  scene.lights.push_back(scene.lights.front());
  scene.lights.back().name = "lamp";
  scene.lights.back().type = LightType::Omni;
  reference::Random random(11);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 3000; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 2.0)) * random.direction());
  const OpaquePath path{"Map", "shadow-map", "nearest", 0};
  for (const int clusters : {1, 3}) {
    scene.shadows.clusters = clusters;
    for (const char* light : {"key", "lamp"}) {
      const std::vector<float> result = answers(path, scene, 0.5, points, light);
      const auto deep = mapPath("chunked", "nearest");
      const auto expected = query(deep, along(deep, scene, kMapSize, 0.0f), points, light);
      std::size_t different = 0;
      for (std::size_t i = 0; i < points.size(); ++i) different += result[i] != expected[i].transmittance;
      EXPECT_EQ(different, 0u) << light << ", clusters " << clusters;
      EXPECT_GT(std::count(result.begin(), result.end(), 0.0f), 300) << light;
    }
  }
}

/// Across the edge of a shadow the filter is a ramp as wide as its square of texels.
TEST(ShadowMap, filtersAsWideAsItIsTold) {
  Scene scene = reference::emptyScene();
  reference::addMesh(scene, reference::quadMesh({1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f}),
                     reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  const double texel = LightFrame(scene, scene.lights.front(), kMapSize).texelAt(5.0);
  std::vector<glm::vec3> points;  // below the light, where the edge's shadow is
  const int count = 400;
  for (int i = 0; i <= count; ++i) points.emplace_back(16.0 * (double(i) / count - 0.5) * texel, -1.0, 0.013);
  for (const int pcf : {0, 1, 2, 5}) {
    const std::vector<float> ramp = answers({"", "shadow-map", "bilinear", pcf}, scene, 0.5, points);
    double between = 0.0;
    for (std::size_t i = 0; i < ramp.size(); ++i) {
      if (i > 0) EXPECT_LE(ramp[i], ramp[i - 1] + 1e-6f) << "pcf " << pcf;
      between += 16.0 / count * (ramp[i] > 0.0f && ramp[i] < 1.0f);
    }
    EXPECT_EQ(ramp.front(), 1.0f);
    EXPECT_EQ(ramp.back(), 0.0f);
    EXPECT_NEAR(between, pcf > 0 ? 2 * pcf + 1 : 0, 0.1) << "pcf " << pcf;
  }
}

/// Which maps the last query built anew, of light "key", and why.
std::vector<std::string> reasonsOf(const Scene& scene) {
  engineOf("buffer").transmittance(scene, "key", {glm::vec3(0.0f)});
  std::vector<std::string> reasons;
  for (const MapStats& map : engineOf("buffer").stats().lights.front().maps) reasons.push_back(map.reason);
  return reasons;
}

TEST(ShadowMap, isBuiltAgainWhenItsDepthsChange) {
  const std::vector<std::string> kept{""};
  const Scene scene = opaque(kPaths.back(), slabScene(Slab::Volume, 0.5f, 1.0f), 0.3);
  reasonsOf(scene);
  EXPECT_EQ(reasonsOf(scene), kept);
  Scene changed = scene;
  changed.shadows.threshold = 0.4f;
  EXPECT_EQ(reasonsOf(changed), std::vector<std::string>{"settings"});
  EXPECT_EQ(reasonsOf(changed), kept);
  changed.shadows.pcf = 3;
  changed.shadows.filter = "nearest";
  changed.shadows.tolerance = 0.1f;
  EXPECT_EQ(reasonsOf(changed), kept) << "these do not concern depths";
  changed.volumes.front().transfer = reference::constantOpacity(0.35f, 1.0f);
  EXPECT_EQ(reasonsOf(changed).front().substr(0, 20), "transfer function of");
  EXPECT_EQ(answers(kPaths.back(), changed, 0.4, {{0.1f, -1.0f, 0.1f}}), std::vector<float>{1.0f});
  changed.lights.front().position.x += 0.1f;
  EXPECT_EQ(reasonsOf(changed), std::vector<std::string>{"light moved"});
}

TEST(ShadowMap, ofOneLightStaysWhenAnotherIsGone) {
  Scene scene = opaque(kPaths.back(), slabScene(Slab::Sheet, 0.9f, 1.0f), 0.5);
  scene.lights.push_back(scene.lights.front());
  scene.lights.back().name = "fill";
  scene.lights.back().position.x = 0.7f;
  scene.lights.back().type = LightType::Omni;
  std::swap(scene.lights[0], scene.lights[1]);
  const std::vector<glm::vec3> points{{0.1f, -1.0f, 0.1f}, {0.1f, 1.0f, 0.1f}};
  const auto all = engineOf("buffer").transmittance(scene, "key", points);
  EXPECT_EQ(engineOf("buffer").stats().memory.strategy, "depth");
  EXPECT_EQ(engineOf("buffer").stats().memory.bytesUsed, 7u * kMapSize * kMapSize * sizeof(float));
  scene.lights[0].position.z += 0.2f;  // "key" keeps its map, which lies behind those of "fill"
  EXPECT_EQ(largestDifference(engineOf("buffer").transmittance(scene, "key", points), all), 0.0);
  EXPECT_EQ(engineOf("buffer").stats().lights[1].maps.front().reason, "");
  scene.lights[0].type = LightType::Spot;  // now it has to move
  EXPECT_EQ(largestDifference(engineOf("buffer").transmittance(scene, "key", points), all), 0.0);
  EXPECT_EQ(engineOf("buffer").stats().lights[1].maps.front().reason, "");
  EXPECT_EQ(all[0].transmittance, 0.0f);
  EXPECT_EQ(all[1].transmittance, 1.0f);
}

}  // namespace
}  // namespace cdsm::property
