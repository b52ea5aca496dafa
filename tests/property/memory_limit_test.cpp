// SPDX-License-Identifier: Apache-2.0
// shadows.memory_limit_mb with real maps: they fit, and what was rendered before changes nothing.
#include <gtest/gtest.h>

#include "engine_paths.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr float kTolerance = 0.002f;

Scene limited(float limit, const std::string& memory, const std::string& onOverflow = "coarsen") {
  Scene scene = along(mapPath(memory), reference::randomScene(5), 64, kTolerance);
  scene.shadows.memoryLimitMb = limit;
  scene.shadows.onOverflow = onOverflow;
  return scene;
}

std::vector<glm::vec3> points() {
  reference::Random random(3);
  std::vector<glm::vec3> list;
  for (int i = 0; i < 300; ++i) list.push_back(1.5f * random.direction());
  return list;
}

const FrameStats& statsOf(const Scene& scene) {
  query(mapPath(), scene, {glm::vec3(0.0f)});
  return engineOf("buffer").stats();
}

/// Between what the maps need as they are and what they need at least, in MiB.
float tightLimit(const std::string& memory) {
  const double whole = double(statsOf(limited(0.0f, memory)).memory.bytesReserved);
  Scene coarse = limited(0.0f, memory);
  coarse.shadows.tolerance = 0.9f;
  const double least = double(statsOf(coarse).memory.bytesReserved);
  EXPECT_LT(least, whole);
  return float(0.5 * (whole + least) / 1048576.0);
}

class MemoryLimit : public ::testing::TestWithParam<const char*> {};

TEST_P(MemoryLimit, coarsensUntilTheMapsFit) {
  const float limit = tightLimit(GetParam());
  const FrameStats stats = statsOf(limited(limit, GetParam()));
  EXPECT_LE(stats.memory.bytesReserved, stats.memory.limit);
  EXPECT_EQ(stats.memory.limit, std::uint64_t(double(limit) * 1048576.0));
  EXPECT_GT(stats.memory.tolerance, double(kTolerance));
  ASSERT_EQ(stats.warnings.size(), 1u);
  EXPECT_NE(stats.warnings[0].find("shadows.memory_limit_mb"), std::string::npos);
}

TEST_P(MemoryLimit, doesNotDependOnWhatWasRenderedBefore) {
  const Scene scene = limited(tightLimit(GetParam()), GetParam());
  Scene other = scene;
  other.lights.front().cutoff *= 0.5f;
  statsOf(other);
  const auto after = query(mapPath(), scene, points());
  const double tolerance = engineOf("buffer").stats().memory.tolerance;
  Engine fresh;
  const auto alone = fresh.transmittance(scene, "key", points());
  EXPECT_EQ(fresh.stats().memory.tolerance, tolerance);
  EXPECT_EQ(largestDifference(after, alone), 0.0);
  const auto kept = fresh.transmittance(scene, "key", points());
  EXPECT_EQ(fresh.stats().memory.tolerance, tolerance);
  EXPECT_EQ(largestDifference(kept, alone), 0.0);
}

TEST_P(MemoryLimit, leavesMapsThatFitAlone) {
  const FrameStats stats = statsOf(limited(1024.0f, GetParam()));
  EXPECT_EQ(stats.memory.tolerance, double(kTolerance));
  EXPECT_TRUE(stats.warnings.empty());
}

TEST_P(MemoryLimit, refusesAndStaysUsable) {
  const float limit = tightLimit(GetParam());
  EXPECT_THROW(statsOf(limited(limit, GetParam(), "error")), Error);
  EXPECT_THROW(statsOf(limited(1e-4f, GetParam())), Error);
  EXPECT_EQ(statsOf(limited(0.0f, GetParam())).memory.tolerance, double(kTolerance));
}

INSTANTIATE_TEST_SUITE_P(Strategies, MemoryLimit, ::testing::Values("atlas", "chunked"));

}  // namespace
}  // namespace cdsm::property
