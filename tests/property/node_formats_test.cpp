// SPDX-License-Identifier: Apache-2.0
// Formats of nodes in whole engines: what they add to the error is part of the tolerance, whatever the strategy.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine_paths.hpp"
#include "memory/node_format.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 96;
/// Single precision of depths and points.
constexpr double kSlack = 1e-4;

Path small(const std::string& memory, const std::string& filter = "bilinear") {
  Path path = mapPath(memory, filter);
  path.format = "unorm16";
  return path;
}

/// 300 sheets of little opacity, aslant.
Scene sheets() {
  Scene scene = reference::emptyScene();
  scene.lights.front().position = {1.0f, 4.0f, 0.5f};
  reference::addMesh(scene, reference::stackMesh(300, 1.0f, 2.0f / 300.0f, 1.0f),
                     reference::addMaterial(scene, glm::vec3(1), 0.01f));
  return scene;
}

struct Case {
  std::string name;
  Scene scene;
};

std::vector<Case> cases() {
  std::vector<Case> list{{"Sheets300", sheets()}};
  for (const std::uint32_t seed : {1u, 2u, 3u, 5u, 8u})
    list.push_back({"Random" + std::to_string(seed), reference::randomScene(seed)});
  list.push_back({"Lights4", reference::randomScene(4)});
  list.back().scene.lights = reference::otherLights(4);
  return list;
}

std::vector<glm::vec3> somePoints(int count) {
  reference::Random random(78);
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(float(random.uniform(0.0, 2.0)) * random.direction());
  return points;
}

class NodeFormats : public ::testing::TestWithParam<std::size_t> {
 protected:
  Case test_ = cases()[GetParam()];
  std::vector<glm::vec3> points_ = somePoints(3000);
};

TEST_P(NodeFormats, answerTheSameInAllStrategies) {
  const Path chunked = small("chunked");
  const auto expected = query(chunked, along(chunked, test_.scene, kMapSize, 0.005f), points_);
  for (const char* memory : {"atlas", "exact", "tiled", "counted"}) {
    const auto found = query(small(memory), along(small(memory), test_.scene, kMapSize, 0.005f), points_);
    EXPECT_LE(largestDifference(found, expected), 1e-5) << memory;
  }
}

/// The points moved away from the light, or with a negative distance towards it.
std::vector<glm::vec3> moved(const Light& light, std::vector<glm::vec3> points, float distance) {
  for (glm::vec3& p : points)
    p += distance * glm::normalize(light.type == LightType::Directional ? light.direction : p - light.position);
  return points;
}

/// |V' - V| <= tolerance but for the depth, which may be off by one step: V a step nearer and a step farther bound V'.
TEST_P(NodeFormats, areWithinTheToleranceAtAStepFromTheDepth) {
  const Light& light = test_.scene.lights.front();
  const float step = 12.0f / 65534.0f;  // no tile is longer, and no ray is that oblique
  const Path plain = mapPath("exact", "nearest");
  const Scene exact = along(plain, test_.scene, kMapSize, 0.0f);
  const auto nearer = query(plain, exact, moved(light, points_, -step));
  const auto farther = query(plain, exact, moved(light, points_, step));
  for (const float tolerance : {0.0005f, 0.01f, 0.05f}) {
    const auto found =
        query(small("exact", "nearest"), along(small("exact", "nearest"), test_.scene, kMapSize, tolerance), points_);
    const double bound = double(memory::nodeFormat("unorm16", "grey").compressionTolerance(tolerance)) + 1e-5 + kSlack;
    int moved = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (found[i].lit != nearer[i].lit || found[i].lit != farther[i].lit) continue;  // at the cone's edge
      const bool within = found[i].transmittance <= nearer[i].transmittance + bound &&
                          found[i].transmittance >= farther[i].transmittance - bound;
      moved += !within;
    }
    EXPECT_LE(moved, 3) << "tolerance " << tolerance;  // points at the border of two texels, moved to the other one
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, NodeFormats, ::testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& instance) { return cases()[instance.param].name; });

TEST(SmallNodes, takeHalfTheBytesOfNodesAndFitWhereLargeOnesDoNot) {
  Scene scene = along(mapPath("exact"), reference::randomScene(5), kMapSize, 0.002f);
  const auto memoryOf = [&](const std::string& format) {
    scene.shadows.nodeFormat = format;
    query(mapPath(), scene, {glm::vec3(0.0f)});
    return engineOf("buffer").stats().memory;
  };
  const MemoryStats large = memoryOf("float32"), few = memoryOf("unorm16");
  EXPECT_EQ(large.bytesPerNode, 8.0);
  EXPECT_EQ(few.bytesPerNode, 4.0);
  EXPECT_LT(few.bytesReserved, large.bytesReserved * 3 / 4);
  EXPECT_EQ(few.bytesWasted, 0u);
  scene.shadows.memoryLimitMb = float(1.01 * double(few.bytesReserved) / 1048576.0);
  scene.shadows.onOverflow = "coarsen";
  EXPECT_EQ(memoryOf("unorm16").tolerance, double(0.002f));
  EXPECT_GT(memoryOf("float32").tolerance, double(0.002f));
}

TEST(SmallNodes, doNotMakeSurfacesShadowThemselves) {
  Scene scene = reference::emptyScene();
  scene.shadows.bias = 1e-6f;  // none to speak of: what lies on the surface is asked for
  reference::addMesh(scene, reference::stackMesh(1, -0.5f, 1.0f, 3.0f),
                     reference::addMaterial(scene, glm::vec3(1), 1.0f));
  reference::addMesh(scene, reference::stackMesh(1, -900.0f, 1.0f, 1000.0f),
                     reference::addMaterial(scene, glm::vec3(1), 1.0f));  // makes the steps of depth long
  scene.lights.front().position = {1.0f, 3.0f, 0.5f};
  scene.image.width = scene.image.height = 48;
  const Image plain = engineOf("buffer").render(along(mapPath("exact"), scene, kMapSize, 0.01f));
  const Image found = engineOf("buffer").render(along(small("exact"), scene, kMapSize, 0.01f));
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) ASSERT_GE(found.pixels[i][0], plain.pixels[i][0] - 1e-4f) << i;
}

}  // namespace
}  // namespace cdsm::property
