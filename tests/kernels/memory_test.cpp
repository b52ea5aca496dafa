// SPDX-License-Identifier: Apache-2.0
// Memory strategies alone: texel by texel, bit by bit the same nodes in all that keep every node, whatever a scene asks
// for; maps that are kept; bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "built_maps.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::kernels {
namespace {

bool same(const Nodes& a, const Nodes& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

void expectSame(const Texels& found, const Texels& expected, const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  std::size_t different = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (same(found[i], expected[i])) continue;
    if (different++ == 0)
      ADD_FAILURE() << what << ": texel " << i << " has " << found[i].size() << " nodes, not the expected "
                    << expected[i].size();
  }
  EXPECT_EQ(different, 0u) << what;
}

std::size_t nodesOf(const Texels& texels) {
  std::size_t nodes = 0;
  for (const Nodes& texel : texels) nodes += texel.size();
  return nodes;
}

/// `count` sheets across the light's way, half a map wide, each of little opacity; every one makes nodes.
Scene sheets(int count, float half) {
  Scene scene = reference::emptyScene();
  scene.shadows.tolerance = 0.0f;
  reference::addMesh(scene, reference::stackMesh(count, 1.0f, 2.0f / float(count), half),
                     reference::addMaterial(scene, glm::vec3(1), 0.5f / float(count)));
  return scene;
}

/// Small triangles that lie in a few tiles of the map, one behind the other.
Scene crowd(int count) {
  Scene scene = reference::emptyScene();
  scene.shadows.tolerance = 0.0f;
  reference::Random random(3);
  const auto around = [&](float reach) { return float(random.uniform(-reach, reach)); };
  reference::MeshParts mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 middle(around(0.25f), around(1.0f), around(0.25f));
    const auto first = glm::uint(mesh.positions.size());
    for (int k = 0; k < 3; ++k)
      mesh.positions.push_back(middle + glm::vec3(around(0.06f), around(0.01f), around(0.06f)));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  reference::addMesh(scene, std::move(mesh), reference::addMaterial(scene, glm::vec3(1), 1e-3f));
  return scene;
}

/// Half of the map empty, the other half with more than scratch memory holds.
Scene uneven() {
  Scene scene = sheets(100, 1.0f);
  reference::addVolume(scene,
                       reference::makeVolume(VoxelType::UInt8, glm::uvec3(16), {-1.0f, -2.0f, -1.0f},
                                             {0.0f, -1.0f, 1.0f}, reference::gaussianBlob),
                       reference::linearOpacity(255.0, 0.9f, 0.3f));
  return scene;
}

struct Case {
  std::string name;
  Scene scene;
  int size;
};

std::vector<Case> cases() {
  std::vector<Case> list;
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    list.push_back({"Random" + std::to_string(seed), reference::randomScene(seed), 61});
    list.back().scene.shadows.tolerance = 0.002f;
  }
  list.push_back({"Sheets300", sheets(300, 1.5f), 40});
  list.push_back({"Triangles100000", crowd(100000), 64});
  list.push_back({"Layers5000", sheets(5000, 0.6f), 16});
  list.push_back({"Uneven", uneven(), 70});
  list.push_back({"Empty", reference::emptyScene(), 8});
  return list;
}

class MemoryCase : public ::testing::TestWithParam<std::size_t> {};

TEST_P(MemoryCase, hasTheSameNodesInEveryStrategy) {
  const Case test = cases()[GetParam()];
  Texels expected;
  for (const Strategy& strategy : exactStrategies()) {
    MapBuilder builder(strategy);
    builder.build({test.scene}, test.size);
    const Texels texels = builder.read(0);
    if (expected.empty()) expected = texels;
    expectSame(texels, expected, strategy.name);
    const memory::NodeCounts counts = builder.memory().nodeCounts(0);
    EXPECT_EQ(counts.total, nodesOf(expected)) << strategy.name;
    const MemoryStats stats = builder.memory().stats();
    EXPECT_EQ(stats.bytesReserved, stats.bytesUsed + stats.bytesWasted) << strategy.name;
    if (strategy.name != "atlas" && strategy.name.find("tiled") == std::string::npos)
      EXPECT_EQ(stats.bytesWasted, 0u) << strategy.name;
  }
}

TEST_P(MemoryCase, hasTheSameNodesOf16BitsInEveryStrategy) {
  const Case test = cases()[GetParam()];
  Scene scene = test.scene;
  scene.shadows.tolerance = std::max(scene.shadows.tolerance, 2e-5f);
  Texels expected;
  for (const Strategy& strategy : exactStrategies()) {
    if (strategy.name.find("Passes") != std::string::npos) continue;
    MapBuilder builder(strategy, "buffer", "unorm16");
    builder.build({scene}, test.size);
    const Texels texels = builder.read(0);
    if (expected.empty()) expected = texels;
    expectSame(texels, expected, strategy.name);
    const MemoryStats stats = builder.memory().stats();
    EXPECT_EQ(stats.bytesPerNode, 4.0) << strategy.name;
    EXPECT_EQ(stats.bytesReserved, stats.bytesUsed + stats.bytesWasted) << strategy.name;
  }
  if (!canFetch("image") || !scene.volumes.empty()) return;  // images interpolate voxels in another way
  MapBuilder builder(strategyNamed("exact"), "image", "unorm16");
  builder.build({scene}, test.size);
  expectSame(builder.read(0), expected, "through images");
}

TEST_P(MemoryCase, hasTheSameNodesThroughImages) {
  const Case test = cases()[GetParam()];
  if (!canFetch("image")) GTEST_SKIP() << "the device has no images";
  if (!test.scene.volumes.empty()) GTEST_SKIP() << "images interpolate voxels in another way";
  MapBuilder plain(strategyNamed("chunked"));
  plain.build({test.scene}, test.size);
  for (const char* name : {"exact", "tiled", "counted"}) {
    MapBuilder builder(strategyNamed(name), "image");
    builder.build({test.scene}, test.size);
    expectSame(builder.read(0), plain.read(0), name);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MemoryCase, ::testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& instance) { return cases()[instance.param].name; });

TEST(Memory, hasTheRoomThatTheCasesAreFor) {
  MapBuilder builder(strategyNamed("exact"));
  builder.build({sheets(5000, 0.6f)}, 16);
  EXPECT_TRUE(builder.maps()[0].wideTable) << "no tile has 2^16 nodes";
  EXPECT_GE(builder.memory().nodeCounts(0).most, 5000u);
  EXPECT_EQ(builder.reports().size(), 1u) << "no tile had too little room";
  builder.build({uneven()}, 70);
  EXPECT_FALSE(builder.maps()[0].wideTable);
}

/// The scene lit from elsewhere.
Scene lit(Scene scene, float x) {
  scene.lights.front().position.x += x;
  return scene;
}

TEST(Memory, ofKeptMapsStays) {
  const Scene scene = uneven();
  const std::vector<Scene> lights{lit(scene, 0.0f), lit(scene, 0.5f), lit(scene, 1.0f)};
  for (const Strategy& strategy : exactStrategies()) {
    MapBuilder builder(strategy);
    builder.build(lights, 70);
    const Texels first = builder.read(0), second = builder.read(1), third = builder.read(2);
    EXPECT_FALSE(same(first[35 * 70 + 35], third[35 * 70 + 35])) << "the maps should differ";
    builder.build({lights[2], lit(scene, -0.4f), lights[0]}, 70, {2, memory::kBuildAnew, 0});
    expectSame(builder.read(0), third, strategy.name + ", third map kept as first");
    expectSame(builder.read(2), first, strategy.name + ", first map kept as third");
    builder.build({lights[1], lights[0]}, 70, {memory::kBuildAnew, 2});
    expectSame(builder.read(0), second, strategy.name + ", second map built again");
    expectSame(builder.read(1), first, strategy.name + ", first map kept twice");
  }
}

TEST(Memory, ofKeptMapsKeepsTheDepthsOfTheirTiles) {
  const Scene scene = uneven();
  MapBuilder builder(strategyNamed("exact"), "buffer", "unorm16");
  builder.build({lit(scene, 0.0f), lit(scene, 0.5f), lit(scene, 1.0f)}, 70);
  const auto scales = [&](std::size_t map) { return builder.tileDepths(map); };
  const auto first = scales(0), third = scales(2);
  EXPECT_EQ(first.size(), 81u);
  EXPECT_NE(first, third) << "the maps should differ";
  builder.build({lit(scene, 1.0f), lit(scene, -0.4f), lit(scene, 0.0f)}, 70, {2, memory::kBuildAnew, 0});
  EXPECT_EQ(scales(0), third);
  EXPECT_EQ(scales(2), first);
}

TEST(Memory, growsOnceForTheMapsOfAnAnimation) {
  for (const char* name : {"exact", "tiled"}) {
    MapBuilder builder(strategyNamed(name));
    const Scene scene = sheets(7, 4.0f);  // 13 nodes in a texel: more than a first map has room for
    builder.build({scene}, 64);
    EXPECT_EQ(builder.reports().size(), 1u) << name;
    builder.build({lit(scene, 0.02f)}, 64);
    EXPECT_EQ(builder.reports().size(), 0u) << name;
  }
}

TEST(Memory, ofFixedSizeKeepsBothEndsAndFalls) {
  MapBuilder all(strategyNamed("chunked"));
  all.build({uneven()}, 70);
  const Texels expected = all.read(0);
  for (const int room : {2, 5, 16}) {
    MapBuilder builder(fixedStrategy(room));
    builder.build({uneven()}, 70);
    const Texels texels = builder.read(0);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const Nodes &few = texels[i], &many = expected[i];
      if (many.size() <= std::size_t(room)) {
        ASSERT_TRUE(same(few, many)) << "texel " << i << " had room for its nodes";
        continue;
      }
      ASSERT_EQ(few.size(), std::size_t(room)) << "texel " << i;
      ASSERT_TRUE(few.front().x == many.front().x && few.front().y == many.front().y) << "start of texel " << i;
      ASSERT_TRUE(few.back().x == many.back().x && few.back().y == many.back().y) << "end of texel " << i;
      for (std::size_t k = 1; k < few.size(); ++k)
        ASSERT_TRUE(few[k].x >= few[k - 1].x && few[k].y <= few[k - 1].y) << "texel " << i << " rises";
    }
    EXPECT_GT(builder.memory().stats().mergeError, 0.0) << room;
  }
}

}  // namespace
}  // namespace cdsm::kernels
