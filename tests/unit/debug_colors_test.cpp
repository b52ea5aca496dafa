// SPDX-License-Identifier: Apache-2.0
// Colours of debug pictures: the scale rises evenly, clusters differ, recolouring leaves shadows alone.
#include "engine/debug_colors.hpp"

#include <gtest/gtest.h>

#include "reference/test_scenes.hpp"
#include "scene/changes.hpp"

namespace cdsm::engine {
namespace {

float luminance(const glm::vec3& c) { return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

TEST(DebugColors, GetBrighterInEvenSteps) {
  for (int i = 1; i <= 100; ++i) {
    const glm::vec3 before = scaleColor(float(i - 1) / 100.0f), color = scaleColor(float(i) / 100.0f);
    // the cube root of luminance is lightness, nearly
    EXPECT_NEAR(std::cbrt(luminance(color)) - std::cbrt(luminance(before)), 0.0066f, 0.0016f) << i;
    EXPECT_TRUE(glm::all(glm::lessThanEqual(color, glm::vec3(1.0f)))) << i;
  }
  EXPECT_GT(luminance(scaleColor(0.0f)), 0.005f) << "darker than nothing would be";
  EXPECT_EQ(scaleColor(1.5f), scaleColor(1.0f));
}

TEST(DebugColors, OfEightClustersDiffer) {
  for (unsigned i = 0; i < 8; ++i) {
    EXPECT_EQ(clusterColor(i), clusterColor(i + 8));
    for (unsigned k = 0; k < i; ++k) EXPECT_GT(glm::length(clusterColor(i) - clusterColor(k)), 0.2f) << i << ", " << k;
  }
}

TEST(DebugColors, OfCountsEndAtTheGreatest) {
  const auto rays = countColors({kNothing, 0, 3}, 3);
  EXPECT_EQ(rays[0].w, 0.0f);
  EXPECT_EQ(rays[1].x, scaleColor(0.0f).x);
  EXPECT_EQ(rays[2].x, scaleColor(1.0f).x);
  EXPECT_EQ(countColors({0}, 0)[0].w, 1.0f);
}

TEST(DebugColors, OfClustersLeaveShadowsAlone) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Scene scene = reference::randomScene(seed);
    std::vector<technique::MapCluster> clusters(1);
    clusters[0].objects = {0};
    const Scene colored = inClusterColors(scene, clusters, 0);
    for (unsigned i = 0; i < scene.meshes.size() + scene.volumes.size(); ++i)
      EXPECT_EQ(scene::casterChange(scene, colored, i), scene::CasterChange::None) << "seed " << seed;
    ASSERT_EQ(colored.meshes.size(), scene.meshes.size());
    EXPECT_EQ(colored.materials[colored.meshes[0].material].diffuse, clusterColor(0));
    for (const Volume& volume : colored.volumes) EXPECT_EQ(volume.transfer.color[0].color, glm::vec3(0.45f));
  }
}

}  // namespace
}  // namespace cdsm::engine
