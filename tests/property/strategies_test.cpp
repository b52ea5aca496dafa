// SPDX-License-Identifier: Apache-2.0
// Whole engines with the strategies that are special: one that a program brings along, and "fixed", whose error is
// reported and not bounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "engine_paths.hpp"
#include "reference/test_scenes.hpp"
#include "strategies/counted.hpp"
#include "technique/registry.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 96;

std::vector<glm::vec3> somePoints(int count) {
  reference::Random random(77);
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 2.0)) * random.direction());
  return points;
}

/// Known to the engines of this program from its start.
const bool registered = [] {
  technique::addMemoryStrategy("counted", [](auto& settings, auto& device) {
    return std::make_unique<strategies::Counted>(device,
                                                 memory::nodeFormat(settings.nodeFormat, settings.transmittance));
  });
  return true;
}();

TEST(OwnStrategy, answersAsTheOthersDo) {
  ASSERT_TRUE(registered);
  const std::vector<glm::vec3> points = somePoints(2000);
  for (const std::uint32_t seed : {1u, 4u}) {
    const Scene scene = reference::randomScene(seed);
    for (const char* fetch : {"buffer", "image"}) {
      if (!canFetch(fetch)) continue;
      Path chunked = mapPath("chunked"), own = mapPath("counted");
      chunked.fetch = own.fetch = fetch;
      const auto expected = query(chunked, along(chunked, scene, kMapSize, 0.005f), points);
      EXPECT_LE(largestDifference(query(own, along(own, scene, kMapSize, 0.005f), points), expected), 1e-5) << seed;
      EXPECT_EQ(engineOf(fetch).stats().memory.strategy, "counted");
    }
  }
}

TEST(OwnStrategy, rendersTheSameImage) {
  Scene scene = reference::randomScene(2);
  scene.image.width = scene.image.height = 64;
  const Image expected = engineOf("buffer").render(along(mapPath("chunked"), scene, kMapSize, 0.005f));
  const Image found = engineOf("buffer").render(along(mapPath("counted"), scene, kMapSize, 0.005f));
  for (std::size_t i = 0; i < expected.pixels.size(); ++i)
    for (int k = 0; k < 4; ++k) ASSERT_NEAR(found.pixels[i][k], expected.pixels[i][k], 1e-5f) << "pixel " << i;
}

TEST(OwnStrategy, ofAnUnknownNameIsRefused) {
  const Path path = mapPath("nowhere");
  try {
    query(path, along(path, reference::emptyScene(), kMapSize, 0.01f), {glm::vec3(0.0f)});
    ADD_FAILURE() << "was not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("chunked, atlas, exact, tiled, fixed, counted"), std::string::npos)
        << error.what();
  }
}

/// Smoke with sheets in it: functions of some dozens of nodes.
Scene layeredScene() {
  Scene scene = reference::emptyScene();
  reference::addVolume(
      scene, reference::makeVolume(VoxelType::UInt8, glm::uvec3(24), glm::vec3(-1), glm::vec3(1), reference::smoke),
      reference::linearOpacity(255.0, 0.9f, 0.25f));
  reference::addMesh(scene, reference::stackMesh(12, 0.8f, 0.13f, 1.0f),
                     reference::addMaterial(scene, glm::vec3(1), 0.08f));
  return scene;
}

std::vector<Transmittance> withNodes(int nodes, const std::vector<glm::vec3>& points) {
  const Path path = mapPath("fixed", "nearest");
  Scene scene = along(path, layeredScene(), kMapSize, 0.001f);
  scene.shadows.maxNodes = nodes;
  return query(path, scene, points);
}

TEST(FixedMemory, errsLessTheMoreNodesThereAre) {
  const std::vector<glm::vec3> points = somePoints(20000);
  const Path path = mapPath("chunked", "nearest");
  const auto exact = query(path, along(path, layeredScene(), kMapSize, 0.001f), points);
  double before = 1.0, last = 1.0;
  for (const int nodes : {2, 4, 8, 16, 32, 64}) {
    const auto found = withNodes(nodes, points);
    const MemoryStats memory = engineOf("buffer").stats().memory;
    double largest = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double error = std::abs(double(found[i].transmittance) - exact[i].transmittance);
      largest = std::max(largest, error);
      squares += error * error;
    }
    const double rms = std::sqrt(squares / double(points.size()));
    std::cout << nodes << " nodes: largest error " << largest << ", rms " << rms << ", reported " << memory.mergeError
              << "\n";
    EXPECT_LE(largest, memory.mergeError + 1e-5) << nodes << " nodes";
    EXPECT_LT(rms, before) << nodes << " nodes";
    EXPECT_GE(memory.bytesReserved, std::uint64_t(kMapSize) * kMapSize * nodes * 8) << nodes;
    EXPECT_LE(memory.bytesReserved, std::uint64_t(kMapSize) * kMapSize * nodes * 8 + 64) << nodes;
    before = rms;
    last = largest;
  }
  EXPECT_LT(last, 0.02);
}

TEST(FixedMemory, isExactWhereNodesSuffice) {
  const std::vector<glm::vec3> points = somePoints(5000);
  const Path path = mapPath("chunked", "nearest");
  const auto exact = query(path, along(path, layeredScene(), kMapSize, 0.001f), points);
  EXPECT_LE(largestDifference(withNodes(256, points), exact), 1e-6);
  EXPECT_EQ(engineOf("buffer").stats().memory.mergeError, 0.0);
}

}  // namespace
}  // namespace cdsm::property
