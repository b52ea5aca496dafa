// SPDX-License-Identifier: Apache-2.0
// Every path through the engine against every closed form.
#include <gtest/gtest.h>

#include <tuple>

#include "engine_paths.hpp"
#include "reference/analytic_cases.hpp"

namespace cdsm::property {
namespace {

using reference::AnalyticCase;
using reference::analyticCases;

constexpr int kMapSize = 96;
constexpr float kTolerance = 0.002f;

/// Single precision along some hundred steps and crossings.
constexpr double kRounding = 3e-4;

/// With and without clusters.
std::vector<Path> clusteredPaths() {
  std::vector<Path> paths = allPaths();
  paths.push_back(mapPath("chunked", "bilinear", 4));
  paths.push_back(mapPath("atlas", "nearest", 4));
  return paths;
}

std::size_t caseCount() { return analyticCases().size(); }

class ClosedForms : public ::testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  AnalyticCase analytic_ = analyticCases()[std::get<0>(GetParam())];
  Path path_ = clusteredPaths()[std::get<1>(GetParam())];
  Scene scene_ = along(path_, analytic_.scene, kMapSize, kTolerance);

  void SetUp() override {
    if (!canFetch(path_.fetch)) GTEST_SKIP() << "the device has no images";
  }
  double allowed() const {
    const bool map = path_.technique == "deep-shadow-map";
    return kRounding + analytic_.discrete + (map ? static_cast<double>(kTolerance) + analytic_.perTexel : 0.0);
  }
  void expectNothingOutsideOfTheCone() const;
};

TEST_P(ClosedForms, hold) {
  const std::vector<Transmittance> result = query(path_, scene_, analytic_.points);
  ASSERT_EQ(result.size(), analytic_.points.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const glm::vec3& p = analytic_.points[i];
    EXPECT_EQ(result[i].lit, 1) << p.x << " " << p.y << " " << p.z;
    EXPECT_NEAR(result[i].transmittance, analytic_.exact(glm::dvec3(p)), allowed()) << p.x << " " << p.y << " " << p.z;
  }
  expectNothingOutsideOfTheCone();
}

void ClosedForms::expectNothingOutsideOfTheCone() const {
  const Light& light = scene_.lights.front();
  for (const Transmittance& t : query(path_, scene_, reference::unlitPoints(light))) {
    EXPECT_EQ(t.lit, 0);
    EXPECT_EQ(t.transmittance, 0.0f);
  }
  if (light.type == LightType::Directional) return;
  const Transmittance atLight = query(path_, scene_, {light.position}).front();  // either answer, but a number
  EXPECT_TRUE(atLight.transmittance == 0.0f || atLight.transmittance == 1.0f) << atLight.transmittance;
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForms,
                         ::testing::Combine(::testing::Range<std::size_t>(0, caseCount()),
                                            ::testing::Range<std::size_t>(0, clusteredPaths().size())),
                         [](const auto& instance) {
                           return analyticCases()[std::get<0>(instance.param)].name +
                                  clusteredPaths()[std::get<1>(instance.param)].name();
                         });

TEST(Queries, noPointsGiveNoAnswers) {
  const AnalyticCase analytic = analyticCases()[1];
  for (const Path& path : {mapPath(), rayPath()}) {
    EXPECT_TRUE(query(path, along(path, analytic.scene, kMapSize, kTolerance), {}).empty());
  }
}

TEST(Queries, anUnknownLightIsAnError) {
  const AnalyticCase analytic = analyticCases()[1];
  EXPECT_THROW(query(rayPath(), along(rayPath(), analytic.scene, kMapSize, kTolerance), analytic.points, "nobody"),
               Error);
}

}  // namespace
}  // namespace cdsm::property
