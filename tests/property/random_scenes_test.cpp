// SPDX-License-Identifier: Apache-2.0
// Random scenes against brute force in double precision, at points where a map can be right: two texels or more away
// from every silhouette and surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::World;

constexpr int kMapSize = 768;
constexpr float kTolerance = 0.005f;
constexpr int kCandidates = 130;  ///< per light
constexpr int kLeastKept = 20;    ///< per light
constexpr double kSmooth = 0.005;

/// kSmooth over the filter's footprint, as much for the engine's coarser step, the tolerance, and as much for rounding.
constexpr double kAllowed = 0.02;

struct Sample {
  glm::vec3 point;
  glm::dvec3 exact;  ///< of red, green and blue light
};

/// The same transmittance, within kSmooth, two texels to all sides and two texels' width nearer and farther, and with
/// the engine's step.
bool isSmooth(const World& world, const Light& light, const LightFrame& frame, const glm::dvec3& point,
              const glm::dvec3& exact) {
  const glm::dvec3 at = frame.coordinates(point);
  const double reach = 2.0 * frame.texel(), deeper = 2.0 * frame.texelAt(at.z);
  const auto same = [&](const glm::dvec3& p, double step) {
    const glm::dvec3 difference = glm::abs(colorTransmittance(world, light, p, step) - exact);
    return reference::lit(light, p) && glm::all(glm::lessThanEqual(difference, glm::dvec3(kSmooth)));
  };
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      if (!same(frame.point(at.x + dx * reach, at.y + dy * reach, at.z), reference::kFineStep)) return false;
    }
  }
  return same(frame.point(at.x, at.y, at.z - deeper), reference::kFineStep) &&
         same(frame.point(at.x, at.y, at.z + deeper), reference::kFineStep) && same(point, reference::kEngineStep);
}

std::vector<Sample> samplesOf(const World& world, const Light& light, std::uint32_t seed) {
  reference::Random random(seed + 1000u);
  std::vector<Sample> samples;
  for (int i = 0; i < kCandidates; ++i) {
    const glm::vec3 point = static_cast<float>(random.uniform(0.0, 1.8)) * random.direction();
    if (!reference::lit(light, glm::dvec3(point))) continue;
    const LightFrame frame(world.scene, light, kMapSize, glm::dvec3(point));
    const glm::dvec3 exact = reference::colorTransmittance(world, light, glm::dvec3(point));
    if (isSmooth(world, light, frame, glm::dvec3(point), exact)) samples.push_back({point, exact});
  }
  return samples;
}

void expectExact(const Path& path, const Scene& scene, const Light& light, const std::vector<Sample>& samples) {
  std::vector<glm::vec3> points;
  for (const Sample& sample : samples) points.push_back(sample.point);
  const std::vector<Transmittance> result = query(path, along(path, scene, kMapSize, kTolerance), points, light.name);
  ASSERT_EQ(result.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const glm::vec3& p = samples[i].point;
    EXPECT_EQ(result[i].lit, 1) << path.name();
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(result[i].color[channel], samples[i].exact[channel], kAllowed)
          << path.name() << ", light " << light.name << ", point " << p.x << " " << p.y << " " << p.z << ", channel "
          << channel;
  }
}

const std::vector<Path> kPaths{rayPath(), mapPath("chunked", "bilinear"), mapPath("atlas", "nearest"),
                               mapPath("exact", "bilinear"), mapPath("tiled", "nearest")};
const std::vector<Path> kColorPaths{rayPath(), mapPath("exact", "bilinear", 2)};
const std::vector<Path> kClusterPaths{mapPath("chunked", "bilinear", 8), mapPath("chunked", "nearest", 2)};

class RandomScenes : public ::testing::TestWithParam<std::uint32_t> {};

void expectBruteForce(const World& world, std::uint32_t seed, const std::vector<Path>& paths) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const Light& light : world.scene.lights) {
    const std::vector<Sample> samples = samplesOf(world, light, seed);
    std::cout << "seed " << seed << ", light " << light.name << ": " << samples.size() << " of " << kCandidates
              << " points kept\n";
    EXPECT_GE(samples.size(), static_cast<std::size_t>(kLeastKept));
    for (const Path& path : paths) expectExact(path, world.scene, light, samples);
  }
}

TEST_P(RandomScenes, agreeWithBruteForce) { expectBruteForce(reference::randomScene(GetParam()), GetParam(), kPaths); }

/// An omni light among the objects, and parallel light.
TEST_P(RandomScenes, agreeWithBruteForceUnderOtherLights) {
  if (GetParam() > 1) GTEST_SKIP() << "six maps take their time";
  Scene scene = reference::randomScene(GetParam());
  scene.lights = reference::otherLights(GetParam());
  expectBruteForce(scene, GetParam(), kPaths);
}

/// Objects that cast no shadow among others; in every third scene, light from amidst them.
TEST_P(RandomScenes, agreeWithBruteForceWhateverCasts) {
  Scene scene = reference::randomScene(GetParam());
  reference::giveRandomRoles(scene, GetParam());
  scene.shadows.step = 0.02f;  // where less is in the way, what a step misses weighs more
  if (GetParam() % 3 == 0) scene.lights = reference::otherLights(GetParam());
  expectBruteForce(scene, GetParam(), kPaths);
}

/// Spheres, opaque and translucent, among the others; in every second scene, light from amidst them.
TEST_P(RandomScenes, agreeWithBruteForceWithSpheres) {
  if (GetParam() > 3) GTEST_SKIP() << "three seeds have every kind of light and role";
  Scene scene = reference::randomScene(GetParam());
  reference::addRandomSpheres(scene, GetParam());
  scene.shadows.step = 0.02f;  // as above
  if (GetParam() % 3 == 0) reference::giveRandomRoles(scene, GetParam());
  if (GetParam() % 2 == 0) scene.lights = reference::otherLights(GetParam());
  expectBruteForce(scene, GetParam(), kPaths);
  if (GetParam() > 2) return;
  scene.shadows.clusterDistance = 0.1f;
  expectBruteForce(scene, GetParam(), kClusterPaths);
}

/// Light coloured by what it gets through; spheres in every second scene.
TEST_P(RandomScenes, agreeWithBruteForceInColor) {
  if (GetParam() > 2) GTEST_SKIP() << "two seeds tell enough";
  Scene scene = reference::randomScene(GetParam());
  if (GetParam() % 2 == 0) reference::addRandomSpheres(scene, GetParam());
  reference::giveRandomTransmissions(scene, GetParam());
  scene.shadows.step = 0.02f;  // as above
  expectBruteForce(scene, GetParam(), kColorPaths);
}

/// A spot light and parallel light, their casters in clusters.
TEST_P(RandomScenes, agreeWithBruteForceInClusters) {
  if (GetParam() > 1) GTEST_SKIP() << "many maps take their time";
  Scene scene = reference::randomScene(GetParam());
  scene.shadows.clusterDistance = 0.1f;
  scene.lights = {scene.lights.front(), reference::otherLights(GetParam()).back()};
  scene.lights.back().name = "sun";
  expectBruteForce(scene, GetParam(), kClusterPaths);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, ::testing::Range<std::uint32_t>(1, 5));

}  // namespace
}  // namespace cdsm::property
