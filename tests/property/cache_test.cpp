// SPDX-License-Identifier: Apache-2.0
// The cache "volume": at voxel centres it knows what the technique says, between them it is linear, elsewhere the
// technique answers; it is filled anew when light arrives otherwise than before, and for nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "engine_paths.hpp"
#include "frames.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::addMaterial;
using reference::addMesh;

constexpr int kMapSize = 64;
constexpr float kTolerance = 0.005f;
constexpr glm::uvec3 kSize{9, 11, 7};
const glm::vec3 kLow{-1.0f, -0.8f, -0.9f}, kHigh{1.0f, 1.1f, 0.7f};

/// Smoke with a cube inside that throws its shadow through it, above a floor outside of its box.
Scene smokyScene(const std::string& technique) {
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, reference::makeVolume(VoxelType::UInt8, kSize, kLow, kHigh, reference::smoke),
                       reference::linearOpacity(255.0, 0.9f, 1.0f));
  const int material = addMaterial(scene, glm::vec3(0.8f), 1.0f);
  addMesh(scene, reference::boxMesh({-0.3f, 0.2f, -0.3f}, {0.2f, 0.5f, 0.2f}), material);
  addMesh(scene, reference::quadMesh({0.0f, -1.5f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f}), material);
  return along({technique, "chunked", "bilinear", "buffer"}, scene, kMapSize, kTolerance);
}

Scene cached(Scene scene) {
  scene.shadows.cache = "volume";
  return scene;
}

glm::vec3 voxelCenter(const glm::uvec3& voxel) {
  return kLow + (glm::vec3(voxel) + 0.5f) / glm::vec3(kSize) * (kHigh - kLow);
}

/// A place between voxel centres, in voxels.
glm::vec3 placeIn(reference::Random& random) {
  glm::vec3 place;
  for (int i = 0; i < 3; ++i) place[i] = float(random.uniform(0.0, double(kSize[i]) - 1.001));
  return place;
}

class Cached : public ::testing::TestWithParam<const char*> {
 protected:
  Engine engine_{EngineOptions{}};
  Scene scene_ = smokyScene(GetParam());

  std::vector<float> ask(const Scene& scene, const std::vector<glm::vec3>& points) {
    std::vector<float> values;
    for (const Transmittance& t : engine_.transmittance(scene, "key", points)) values.push_back(t.transmittance);
    return values;
  }
};

TEST_P(Cached, knowsWhatTheTechniqueSaysAtVoxels) {
  std::vector<glm::vec3> points;
  for (unsigned z = 0; z < kSize.z; ++z)
    for (unsigned y = 0; y < kSize.y; ++y)
      for (unsigned x = 0; x < kSize.x; ++x) points.push_back(voxelCenter({x, y, z}));
  const std::vector<float> exact = ask(scene_, points), kept = ask(cached(scene_), points);
  int apart = 0;
  for (std::size_t i = 0; i < points.size(); ++i) apart += std::abs(kept[i] - exact[i]) > 1e-4f;
  // a point lies beside its voxel by rounding, which counts at a shadow's hard edge alone
  EXPECT_LE(apart, int(points.size()) / 100);
}

TEST_P(Cached, isLinearBetweenVoxels) {
  reference::Random random(3);
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 place = placeIn(random), base = glm::floor(place), part = place - base;
    std::vector<glm::vec3> corners;
    for (unsigned k = 0; k < 8; ++k)
      corners.push_back(voxelCenter(glm::uvec3(base) + glm::uvec3(k & 1, k >> 1 & 1, k >> 2)));
    corners.push_back(kLow + (place + 0.5f) / glm::vec3(kSize) * (kHigh - kLow));
    const std::vector<float> kept = ask(cached(scene_), corners);
    float expected = 0.0f;
    for (unsigned k = 0; k < 8; ++k) {
      const glm::vec3 weight((k & 1) ? part.x : 1 - part.x, (k & 2) ? part.y : 1 - part.y,
                             (k & 4) ? part.z : 1 - part.z);
      expected += weight.x * weight.y * weight.z * kept[k];
    }
    EXPECT_NEAR(kept[8], expected, 1e-4f) << "place " << place.x << ' ' << place.y << ' ' << place.z;
  }
}

TEST_P(Cached, leavesWhatIsOutsideToTheTechnique) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 100; ++i) points.push_back({-1.5f + 0.03f * float(i), -1.2f, 0.1f});
  EXPECT_EQ(ask(cached(scene_), points), ask(scene_, points));
}

TEST_P(Cached, isFilledWhenLightChangesAndForNothingElse) {
  Scene scene = cached(scene_);
  const auto filled = [&](const std::function<void(Scene&)>& change) {
    change(scene);
    engine_.render(scene);
    return engine_.stats().cache.value().filled;
  };
  EXPECT_TRUE(filled([](Scene&) {}));
  EXPECT_EQ(engine_.stats().cache->bytes, 2u * ((kSize.x * kSize.y * kSize.z + 63) / 64 * 64));
  EXPECT_FALSE(filled([](Scene&) {}));
  EXPECT_FALSE(filled([](Scene& s) { s.camera.position.x += 1.0f; }));
  EXPECT_FALSE(filled([](Scene& s) { s.image.width = 100; }));
  EXPECT_FALSE(filled([](Scene& s) { s.lights[0].color = {1.0f, 0.5f, 0.2f}; }));
  EXPECT_FALSE(filled([](Scene& s) { s.materials[0].diffuse = {1.0f, 0.5f, 0.2f}; }));
  EXPECT_FALSE(filled([](Scene& s) { s.volumes[0].transfer.color[0].color = {1.0f, 0.5f, 0.2f}; }));
  EXPECT_TRUE(filled([](Scene& s) { s.lights[0].position.x += 0.1f; }));
  EXPECT_TRUE(filled([](Scene& s) { s.volumes[0].transfer.opacity[1].opacity = 0.5f; }));
  EXPECT_TRUE(filled([](Scene& s) { s.volumes[0].worldFromObject = movedTo({0.1f, 0.0f, 0.0f}); }));
  EXPECT_TRUE(filled([](Scene& s) { s.meshes[0].worldFromObject = movedTo({0.1f, 0.0f, 0.0f}); }));
  EXPECT_TRUE(filled([](Scene& s) { s.meshes[0].shadow.casts = false; }));
  EXPECT_TRUE(filled([](Scene& s) { s.shadows.filter = "nearest"; }));
  EXPECT_TRUE(filled([](Scene& s) { s.volumes[0].transfer.shadowOpacity = {{0.0f, 0.2f}}; }));
  EXPECT_TRUE(filled([](Scene& s) { s.volumes[0].transfer.opacity[0].opacity = 0.1f; }));  // seen elsewhere now
  EXPECT_TRUE(filled([](Scene& s) { s.lights.push_back(s.lights[0]), s.lights[1].name = "other"; }));
}

TEST_P(Cached, servesAnyCamera) {
  Scene turned = cached(scene_);
  turned.shadows.clusters = 3;
  engine_.render(turned);
  turned.camera.position = {4.0f, 2.0f, -3.0f};
  const Image kept = engine_.render(turned);
  EXPECT_FALSE(engine_.stats().cache->filled);
  // another camera may mean other clusters, whose maps agree to within their tolerance
  EXPECT_LE(rmsDifference(kept, Engine(EngineOptions{}).render(turned)), kTolerance);
}

TEST_P(Cached, showsTheSameToItsResolution) {
  const Image exact = engine_.render(scene_);
  const Image kept = engine_.render(cached(scene_));
  EXPECT_LE(rmsDifference(kept, exact), 0.02);
  EXPECT_FALSE(sameBytes(kept, exact));
}

INSTANTIATE_TEST_SUITE_P(Techniques, Cached, ::testing::Values("deep-shadow-map", "shadow-rays", "shadow-map"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Only what is seen somewhere is filled: under a pane that lets half of the light through, a voxel that was left out
/// would show as brighter, wherever in a macrocell that is not empty it has a say, borders included.
TEST(CachedVoxels, areFilledWhereverTheyAreInterpolated) {
  const glm::uvec3 size{29, 20, 18};  // the last macrocells are cut off
  const auto speck = [](const glm::dvec3& p) {
    return glm::length(p - glm::dvec3(-0.2, -0.4, -0.55)) < 0.2 ? 1.0 : 0.0;
  };
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, reference::makeVolume(VoxelType::UInt8, size, kLow, kHigh, speck),
                       reference::linearOpacity(255.0, 0.01f, 1.0f));
  addMesh(scene, reference::quadMesh({0.0f, 1.5f, 0.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 9.0f}),
          addMaterial(scene, glm::vec3(0.8f), 0.5f));
  scene = cached(along({"shadow-rays", "chunked", "bilinear", "buffer"}, scene, kMapSize, kTolerance));
  std::vector<glm::vec3> points;
  for (unsigned z = 0; z <= 2 * size.z; ++z)
    for (unsigned y = 0; y <= 2 * size.y; ++y)
      for (unsigned x = 0; x <= 2 * size.x; ++x)
        points.push_back(kLow + glm::vec3(x, y, z) / (2.0f * glm::vec3(size)) * (kHigh - kLow));
  Engine engine{EngineOptions{}};
  for (const Transmittance& t : engine.transmittance(scene, "key", points)) ASSERT_LE(t.transmittance, 0.51f);
}

/// A plane in clear air within a volume's box, of any tilt, lies in nobody's shadow.
TEST(CachedSurfaces, doNotShadowThemselves) {
  for (const glm::vec3 tilt : {glm::vec3(0.0f), glm::vec3(0.3f, 0.0f, 0.0f), glm::vec3(0.2f, 0.0f, 0.7f)}) {
    Scene scene = reference::emptyScene();
    reference::addVolume(scene, reference::makeVolume(VoxelType::UInt8, kSize, kLow, kHigh, reference::smoke),
                         reference::constantOpacity(0.0f, 1.0f));
    addMesh(scene, reference::quadMesh({0.0f, 0.1f, 0.0f}, {0.7f, tilt.x, 0.0f}, {0.0f, tilt.z, -0.6f}),
            addMaterial(scene, glm::vec3(0.8f), 1.0f));
    scene = along({"deep-shadow-map", "chunked", "bilinear", "buffer"}, scene, kMapSize, kTolerance);
    Scene unshadowed = scene;
    unshadowed.shadows.technique = "none";
    Engine engine{EngineOptions{}};
    const Image lit = engine.render(unshadowed);
    EXPECT_LE(largestStep(engine.render(cached(scene)), lit), 1e-3f) << "tilt " << tilt.x << ' ' << tilt.z;
  }
}

}  // namespace
}  // namespace cdsm::property
