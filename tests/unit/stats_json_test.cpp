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
  const auto settings = nlohmann::json::parse(statsJson({}, shadows, {})).at("settings");
  EXPECT_EQ(settings.at("technique"), "deep-shadow-map");
  EXPECT_EQ(settings.at("memory"), "chunked");
  EXPECT_EQ(settings.at("map_size"), 64);
  EXPECT_EQ(settings.at("tolerance"), 0.01) << "the digits of the scene file, not of its float";
  EXPECT_EQ(settings.at("filter"), "bilinear");
  EXPECT_EQ(settings.at("clusters"), 4);
  EXPECT_EQ(settings.at("cluster_distance"), 0.1);
  EXPECT_EQ(settings.at("stable"), true);
  EXPECT_EQ(settings.at("rays"), "opaque");
  EXPECT_EQ(settings.at("threshold"), 0.3);
  EXPECT_EQ(settings.at("pcf"), 2);
  EXPECT_EQ(settings.at("step"), 0.0);
  EXPECT_EQ(settings.at("bias"), 0.0);
}

}  // namespace
}  // namespace cdsm::engine
