// SPDX-License-Identifier: Apache-2.0
// The settings in STATS.json are those that were in effect, under the names of the scene file.
#include "engine/stats_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace cdsm::engine {
namespace {

TEST(StatsJson, ShowsTheSettingsByTheirKeys) {
  ShadowSettings shadows;
  shadows.mapSize = 64;
  shadows.clusters = 4;
  shadows.clusterDistance = 0.1f;
  shadows.stable = true;
  shadows.rays = "opaque";
  shadows.threshold = 0.3f;
  shadows.pcf = 2;
  shadows.samples = 21;
  shadows.seed = 7;
  shadows.stratified = true;
  shadows.patch = ShadowSettings::kPatchAuto;
  shadows.softness = 0.1f;
  const auto settings = nlohmann::json::parse(statsJson({}, shadows, {})).at("settings");
  EXPECT_EQ(settings.at("technique"), "deep-shadow-map");
  EXPECT_EQ(settings.at("memory"), "exact");
  EXPECT_EQ(settings.at("node_format"), "float32");
  EXPECT_EQ(settings.at("map_size"), 64);
  EXPECT_EQ(settings.at("tolerance"), 0.01) << "the digits of the scene file, not of its float";
  EXPECT_EQ(settings.at("filter"), "bilinear");
  EXPECT_EQ(settings.at("clusters"), 4);
  EXPECT_EQ(settings.at("cluster_distance"), 0.1);
  EXPECT_EQ(settings.at("stable"), true);
  EXPECT_EQ(settings.at("rays"), "opaque");
  EXPECT_EQ(settings.at("threshold"), 0.3);
  EXPECT_EQ(settings.at("pcf"), 2);
  EXPECT_EQ(settings.at("samples"), 21);
  EXPECT_EQ(settings.at("seed"), 7);
  EXPECT_EQ(settings.at("stratified"), true);
  EXPECT_EQ(settings.at("patch"), "auto");
  EXPECT_EQ(settings.at("softness"), 0.1);
  EXPECT_EQ(settings.at("softness_distance"), 1.0);
  EXPECT_EQ(settings.at("softness_exponent"), 1.0);
  EXPECT_EQ(settings.at("step"), 0.0);
  EXPECT_EQ(settings.at("bias"), 0.0);
  EXPECT_EQ(settings.at("tolerance_mode"), "samples");
  EXPECT_EQ(settings.at("memory_limit_mb"), 0.0);
  EXPECT_EQ(settings.at("on_overflow"), "error");
}

TEST(StatsJson, ShowsTheToleranceOfCoarsenedMaps) {
  FrameStats frame;
  frame.memory.tolerance = 0.02f;
  frame.memory.limit = 1048576;
  frame.warnings = {"coarsened"};
  const auto shown = nlohmann::json::parse(statsJson({}, {}, {frame})).at("frames").at(0);
  EXPECT_EQ(shown.at("memory").at("tolerance"), 0.02);
  EXPECT_EQ(shown.at("memory").at("limit"), 1048576);
  EXPECT_EQ(shown.at("warnings").at(0), "coarsened");
}

TEST(StatsJson, NamesADebugPictureAndItsScale) {
  std::vector<FrameStats> frames(3);
  frames[1].view = ViewStats{"nodes", 37};
  frames[2].view = ViewStats{"clusters", {}};
  const auto list = nlohmann::json::parse(statsJson({}, {}, frames)).at("frames");
  EXPECT_FALSE(list[0].contains("view"));
  EXPECT_EQ(list[1].at("view"), nlohmann::json({{"name", "nodes"}, {"scale", 37}}));
  EXPECT_EQ(list[2].at("view"), nlohmann::json({{"name", "clusters"}}));
}

}  // namespace
}  // namespace cdsm::engine
