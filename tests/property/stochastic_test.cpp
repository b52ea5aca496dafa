// SPDX-License-Identifier: Apache-2.0
// Stochastic maps: their mean over seeds is the exact transmittance, its variance that of as many independent tries as
// a lookup has, and less where the numbers are stratified.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

using reference::World;

constexpr int kMapSize = 128;

/// [Weidner & Linsen 2018, §4], and eight larger ones.
const std::vector<glm::ivec2> kOffsets{{0, 0},  {3, 3},  {-3, 3},  {3, -3}, {-3, -3}, {4, 0},  {-4, 0},
                                       {0, 4},  {0, -4}, {7, 0},   {-7, 0}, {0, 7},   {0, -7}, {6, 6},
                                       {6, -6}, {-6, 6}, {-6, -6}, {10, 0}, {-10, 0}, {0, 10}, {0, -10}};
/// Texels that lookups stay away from the border of a map.
constexpr int kReach = 11;

Scene stochastic(const Scene& scene, int seed, bool stratified = false, int samples = 13,
                 const char* filter = "nearest") {
  Scene result = along({"stochastic", "chunked", filter, "buffer"}, scene, kMapSize, 0.01f);
  result.shadows.seed = seed;
  result.shadows.stratified = stratified;
  result.shadows.samples = samples;
  return result;
}

std::vector<double> answers(const Scene& scene, const std::vector<glm::vec3>& points,
                            const std::string& light = "key") {
  std::vector<double> values;
  for (const Transmittance& t : engineOf("buffer").transmittance(scene, light, points))
    values.push_back(static_cast<double>(t.transmittance));
  return values;
}

/// What is in the way of parallel light, all over its map.
enum class Slab { Volume, Interior, Sheets };

constexpr float kOpacity = 0.4f;

/// Light from above loses the part kOpacity between y = 0.5 and y = -0.5.
Scene slabScene(Slab slab) {
  Scene scene = reference::emptyScene();
  scene.lights.front().type = LightType::Directional;
  scene.lights.front().direction = {0.0f, -1.0f, 0.0f};
  const glm::vec3 low(-2.0f, -0.5f, -2.0f), high(2.0f, 0.5f, 2.0f);
  if (slab == Slab::Volume)
    reference::addVolume(
        scene, reference::makeVolume(VoxelType::UInt8, glm::uvec3(24), low, high, [](const auto&) { return 1.0; }),
        reference::constantOpacity(kOpacity, 1.0f));
  else if (slab == Slab::Interior)
    reference::addMesh(scene, reference::boxMesh(low, high), reference::addMaterial(scene, glm::vec3(0.5f), 0.0f));
  else
    reference::addMesh(scene, reference::stackMesh(2, 0.5f, 1.0f, 2.0f),
                       reference::addMaterial(scene, glm::vec3(0.5f), 1.0f - std::sqrt(1.0f - kOpacity)));
  if (slab == Slab::Interior) scene.meshes.front().interiorExtinction = -std::log1p(-kOpacity);
  return scene;
}

/// Points whose lookups have no texel in common.
std::vector<glm::vec3> distantPoints(const Scene& scene, float y) {
  const LightFrame frame(scene, scene.lights.front(), kMapSize);
  std::vector<glm::vec3> points;
  for (int row = 2 * kReach; row <= kMapSize - 2 * kReach; row += 2 * kReach)
    for (int column = 2 * kReach; column <= kMapSize - 2 * kReach; column += 2 * kReach) {
      const reference::Ray ray = frame.texelRay(column, row);
      const glm::dvec3 p = ray.at((static_cast<double>(y) - ray.origin.y) / ray.direction.y);
      points.emplace_back(p);
    }
  return points;
}

struct Spread {
  double mean = 0.0, variance = 0.0;
  int count = 0;
};

/// Of lookups at depth y, by many seeds.
Spread spreadOf(const Scene& scene, float y, int seeds, bool stratified, int samples, const char* filter) {
  const std::vector<glm::vec3> points = distantPoints(scene, y);
  double sum = 0.0, squares = 0.0;
  for (int seed = 0; seed < seeds; ++seed)
    for (const double t : answers(stochastic(scene, seed, stratified, samples, filter), points)) {
      sum += t;
      squares += t * t;
    }
  Spread spread;
  spread.count = seeds * static_cast<int>(points.size());
  spread.mean = sum / spread.count;
  spread.variance = squares / spread.count - spread.mean * spread.mean;
  return spread;
}

class StochasticSlabs : public ::testing::TestWithParam<Slab> {
 protected:
  const Scene scene_ = slabScene(GetParam());

  double transmittanceAt(float y) const {
    const double all = 1.0 - static_cast<double>(kOpacity);
    if (GetParam() == Slab::Sheets) return y > 0.5f ? 1.0 : y > -0.5f ? std::sqrt(all) : all;
    return std::pow(all, glm::clamp(0.5 - static_cast<double>(y), 0.0, 1.0));
  }
};

/// Within four standard deviations of the mean of as many tries.
TEST_P(StochasticSlabs, areRightInTheMean) {
  constexpr int kSeeds = 12;
  for (const float y : {0.7f, 0.27f, -0.13f, -0.9f})
    for (const char* filter : {"nearest", "bilinear"})
      for (const bool stratified : {false, true}) {
        const double t = transmittanceAt(y);
        const Spread spread = spreadOf(scene_, y, kSeeds, stratified, 13, filter);
        EXPECT_NEAR(spread.mean, t, 4.0 * std::sqrt(t * (1.0 - t) / (13.0 * spread.count)) + 1e-6)
            << "y " << y << ", " << filter << (stratified ? ", stratified" : "");
      }
}

/// The variance of m independent tries, which is known to within sqrt(2 / lookups) of it.
TEST_P(StochasticSlabs, varyAsTheirSamplesAllow) {
  const double t = transmittanceAt(-0.9f);
  for (const int samples : {7, 13, 21}) {
    const Spread spread = spreadOf(scene_, -0.9f, 12, false, samples, "nearest");
    const double expected = t * (1.0 - t) / samples;
    EXPECT_NEAR(spread.variance, expected, 4.0 * std::sqrt(2.0 / spread.count) * expected) << samples << " samples";
  }
}

/// Half of the noise at most, and all of it new with each seed.
TEST_P(StochasticSlabs, areLessNoisyWhenStratified) {
  for (const int samples : {7, 13, 21})
    for (const float y : {0.27f, -0.13f, -0.9f}) {
      if (transmittanceAt(y) == 1.0) continue;
      const double published = std::sqrt(spreadOf(scene_, y, 12, false, samples, "nearest").variance);
      const double stratified = std::sqrt(spreadOf(scene_, y, 12, true, samples, "nearest").variance);
      std::cout << samples << " samples, y " << y << ": noise " << published << ", stratified " << stratified << "\n";
      EXPECT_LE(stratified, 0.5 * published) << samples << " samples, y " << y;
      EXPECT_GT(stratified, 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, StochasticSlabs, ::testing::Values(Slab::Volume, Slab::Interior, Slab::Sheets));

/// A point in the middle of a texel, and the middles of the texels that its lookup asks at the same depth.
struct Probe {
  glm::vec3 point;
  std::vector<glm::dvec3> asked;
};

std::vector<Probe> randomProbes(const Scene& scene, const Light& light, int count, int samples, std::uint32_t seed) {
  reference::Random random(seed);
  std::vector<Probe> probes;
  while (static_cast<int>(probes.size()) < count) {
    const glm::dvec3 seen(static_cast<float>(random.uniform(0.0, 1.6)) * random.direction());
    const LightFrame frame(scene, light, kMapSize, seen);
    const double depth = frame.coordinates(seen).z;
    const int column = random.integer(kReach, kMapSize - 1 - kReach),
              row = random.integer(kReach, kMapSize - 1 - kReach);
    const auto at = [&](int x, int y) {
      const reference::Ray ray = frame.texelRay(x, y);
      return ray.at(depth / frame.depthPerT(x, y));
    };
    Probe probe{glm::vec3(at(column, row)), {}};
    bool inside = glm::length(probe.point) < 1.8f;
    for (int i = 0; i < samples; ++i) {
      probe.asked.push_back(at(column + kOffsets[std::size_t(i)].x, row + kOffsets[std::size_t(i)].y));
      inside = inside && reference::lit(light, probe.asked.back());
    }
    if (inside) probes.push_back(probe);
  }
  return probes;
}

std::vector<glm::vec3> pointsOf(const std::vector<Probe>& probes) {
  std::vector<glm::vec3> points;
  for (const Probe& probe : probes) points.push_back(probe.point);
  return points;
}

/// Where nothing is translucent there is no chance: lookups are the part of exactly those texels that are lit.
TEST(Stochastic, asksTheTexelsOfThePaper) {
  Scene scene = reference::emptyScene();
  const int material = reference::addMaterial(scene, glm::vec3(0.7f), 1.0f);
  reference::addMesh(scene, reference::sphereMesh(0.6f, 24, 12, true), material);
  reference::addMesh(scene, reference::quadMesh({0.5f, -0.7f, 0.2f}, {0.5f, 0.1f, 0.0f}, {0.0f, 0.2f, 0.6f}), material);
  Scene opaque = along({"shadow-map", "chunked", "nearest", "buffer"}, scene, kMapSize, 0.01f);
  opaque.shadows.pcf = 0;
  for (const int samples : {7, 13, 21}) {
    const auto probes = randomProbes(scene, scene.lights.front(), 300, samples, 5);
    const std::vector<double> result = answers(stochastic(scene, 1, false, samples), pointsOf(probes));
    int between = 0;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const std::vector<double> lit =
          answers(opaque, std::vector<glm::vec3>(probes[i].asked.begin(), probes[i].asked.end()));
      double sum = 0.0;
      for (const double t : lit) sum += t;
      EXPECT_NEAR(result[i], sum / samples, 1e-6) << samples << " samples, point " << i;
      between += sum > 0.0 && sum < samples;
    }
    EXPECT_GT(between, 20);
  }
}

class StochasticScenes : public ::testing::TestWithParam<std::uint32_t> {};

/// Any scene, light after light: means over seeds, each within what its tries allow, and all of them together as far
/// off as chance has it.
TEST_P(StochasticScenes, areRightInTheMean) {
  constexpr int kSeeds = 24;
  constexpr double kSteps = 0.004;  // what the ray's step leaves open
  Scene scene = reference::randomScene(GetParam());
  if (GetParam() % 2 == 0) scene.lights = reference::otherLights(GetParam());
  if (GetParam() % 3 == 0) reference::giveRandomRoles(scene, GetParam());
  const World world(scene);
  for (const Light& light : scene.lights) {
    const auto probes = randomProbes(scene, light, 40, 13, GetParam() + 100u);
    const std::vector<glm::vec3> points = pointsOf(probes);
    for (const bool stratified : {false, true}) {
      std::vector<double> means(probes.size(), 0.0);
      for (int seed = 1; seed <= kSeeds; ++seed) {
        const std::vector<double> values = answers(stochastic(scene, seed, stratified), points, light.name);
        for (std::size_t i = 0; i < values.size(); ++i) means[i] += values[i] / kSeeds;
      }
      double squares = 0.0;
      int random = 0;
      for (std::size_t i = 0; i < probes.size(); ++i) {
        double expected = 0.0, variance = 0.0;
        for (const glm::dvec3& p : probes[i].asked) {
          const double t = reference::transmittance(world, light, p, reference::kEngineStep);
          expected += t / 13.0;
          variance += t * (1.0 - t) / (169.0 * kSeeds);
        }
        EXPECT_NEAR(means[i], expected, 4.0 * std::sqrt(variance) + kSteps)
            << "seed " << GetParam() << ", light " << light.name << ", point " << i;
        if (variance < 1e-4) continue;
        squares += (means[i] - expected) * (means[i] - expected) / variance;
        ++random;
      }
      std::cout << light.name << ": " << random << " points by chance, mean square " << squares / random << "\n";
      if (random < 8) continue;
      const double spread = 4.0 * std::sqrt(2.0 / random);
      EXPECT_LE(squares / random, 1.0 + spread);
      if (!stratified) EXPECT_GE(squares / random, 1.0 - spread);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, StochasticScenes, ::testing::Range<std::uint32_t>(1, 3));

/// Which maps the last query built anew, of light "key", and why.
std::string reasonOf(const Scene& scene) {
  engineOf("buffer").transmittance(scene, "key", {glm::vec3(0.0f)});
  return engineOf("buffer").stats().lights.front().maps.front().reason;
}

TEST(Stochastic, isBuiltAgainWhenItsNumbersChange) {
  const Scene scene = slabScene(Slab::Volume);
  reasonOf(stochastic(scene, 1));
  EXPECT_EQ(reasonOf(stochastic(scene, 1)), "");
  EXPECT_EQ(reasonOf(stochastic(scene, 1, false, 21)), "") << "lookups may ask as many texels as they want";
  EXPECT_EQ(reasonOf(stochastic(scene, 2, false, 21)), "settings");
  EXPECT_EQ(reasonOf(stochastic(scene, 2, true, 21)), "settings");
  EXPECT_EQ(reasonOf(stochastic(scene, 2, true, 7)), "settings")
      << "numbers are spread over as many texels as are asked";
  Scene changed = stochastic(scene, 2, true, 7);
  changed.shadows.threshold = 0.1f;
  changed.shadows.pcf = 3;
  changed.shadows.tolerance = 0.1f;
  EXPECT_EQ(reasonOf(changed), "") << "these do not concern photons";
  const MemoryStats memory = engineOf("buffer").stats().memory;
  EXPECT_EQ(memory.strategy, "depth");
  EXPECT_GE(memory.bytesUsed, 12u * kMapSize * kMapSize);
  EXPECT_LT(memory.bytesUsed, 12u * kMapSize * kMapSize + 64u);
}

/// Numbers belong to a texel of a map, wherever the map lies among the others.
TEST(Stochastic, keepsItsNumbersWhenMapsMove) {
  Scene scene = stochastic(slabScene(Slab::Volume), 3);
  scene.lights.push_back(scene.lights.front());
  scene.lights.front().name = "fill";
  scene.lights.front().type = LightType::Omni;
  scene.lights.front().position = {0.0f, 3.0f, 0.0f};
  const std::vector<glm::vec3> points = distantPoints(slabScene(Slab::Volume), -0.9f);
  const std::vector<double> alone = answers(stochastic(slabScene(Slab::Volume), 3), points);
  const std::vector<double> behind = answers(scene, points);
  scene.lights.front().type = LightType::Spot;
  const std::vector<double> moved = answers(scene, points);
  EXPECT_EQ(behind, alone);
  EXPECT_EQ(moved, alone);
  scene.shadows.seed = 4;
  EXPECT_NE(answers(scene, points), alone);
}

/// The maps of clusters are multiplied: the mean is right only if their numbers are independent.
TEST(Stochastic, drawsNumbersOfItsOwnForEachCluster) {
  Scene scene = reference::emptyScene();
  scene.lights.front().type = LightType::Directional;
  scene.lights.front().direction = {0.0f, -1.0f, 0.0f};
  const int material = reference::addMaterial(scene, glm::vec3(0.5f), 0.5f);
  for (const float half : {0.3f, 3.0f})
    reference::addMesh(scene, reference::quadMesh({0.0f, -half, 0.0f}, {half, 0.0f, 0.0f}, {0.0f, 0.0f, half}),
                       material);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 16; ++i) points.emplace_back(-0.2f + 0.12f * float(i % 4), -3.1f, -0.2f + 0.12f * float(i / 4));
  for (const bool stratified : {false, true}) {
    double sum = 0.0;
    constexpr int kSeeds = 60;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      Scene clustered = stochastic(scene, seed, stratified);
      clustered.shadows.clusters = 2;
      for (const double t : answers(clustered, points)) sum += t / (16.0 * kSeeds);
    }
    EXPECT_EQ(engineOf("buffer").stats().lights.front().maps.size(), 2u);
    // a product of two means of 13 tries each varies by less than one of them
    EXPECT_NEAR(sum, 0.25, 4.0 * std::sqrt(0.25 / 13.0 / (16.0 * kSeeds))) << (stratified ? "stratified" : "");
  }
}

}  // namespace
}  // namespace cdsm::property
