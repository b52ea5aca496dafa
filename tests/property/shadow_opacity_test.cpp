// SPDX-License-Identifier: Apache-2.0
// Transfer functions of their own for shadows: light meets the one, the picture shows the other, by every technique.
#include <gtest/gtest.h>

#include "engine_paths.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 128;

std::vector<Path> paths() {
  return {rayPath(),
          mapPath(),
          {"shadow-map", "chunked", "bilinear", "buffer"},
          {"stochastic", "chunked", "bilinear", "buffer"}};
}

/// Smoke above a floor, in front of a camera that sees both.
Scene smokeScene(const TransferFunction& transfer) {
  Scene scene = reference::emptyScene();
  scene.image.width = 48;
  scene.image.height = 32;
  reference::addVolume(scene,
                       reference::makeVolume(VoxelType::UInt8, glm::uvec3(40), glm::vec3(-1.0f), glm::vec3(1.0f),
                                             [](const glm::dvec3& p) { return reference::smoke(p); }),
                       transfer);
  reference::addMesh(scene, reference::quadMesh({0.0f, -1.2f, 0.0f}, {3.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 3.0f}),
                     reference::addMaterial(scene, glm::vec3(0.8f), 1.0f));
  return scene;
}

std::vector<glm::vec3> somePoints() {
  reference::Random random(3);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 500; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 1.4)) * random.direction());
  return points;
}

float largestStep(const Image& a, const Image& b) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      largest = std::max(largest, std::abs(a.pixels[i][channel] - b.pixels[i][channel]));
  return largest;
}

const TransferFunction kThin = reference::linearOpacity(255.0, 0.3f, 0.5f);
const TransferFunction kThick = reference::linearOpacity(180.0, 0.95f, 0.5f);

TransferFunction thinWithShadowsOf(const TransferFunction& other) {
  TransferFunction transfer = kThin;
  transfer.shadowOpacity = other.opacity;
  return transfer;
}

class ShadowOpacity : public ::testing::TestWithParam<std::size_t> {
 protected:
  Scene scene(const TransferFunction& transfer) const { return along(path_, smokeScene(transfer), kMapSize, 0.01f); }
  std::vector<Transmittance> ask(const TransferFunction& transfer) const {
    return query(path_, scene(transfer), somePoints());
  }
  Image render(const TransferFunction& transfer) const { return engineOf("buffer").render(scene(transfer)); }

  const Path path_ = paths()[GetParam()];
};

TEST_P(ShadowOpacity, isWhatLightMeets) {
  // one photon in a thousand may change sides where the tables of the two are not cut alike
  const double limit = path_.technique == "stochastic" ? 0.5 : 1e-3;
  const auto wanted = ask(kThick);
  EXPECT_LE(largestDifference(ask(thinWithShadowsOf(kThick)), wanted), limit);
  EXPECT_GT(largestDifference(ask(kThin), wanted), 0.3);
}

TEST_P(ShadowOpacity, isTheOpacityUnlessItIsGiven) {
  EXPECT_EQ(largestDifference(ask(thinWithShadowsOf(kThin)), ask(kThin)), 0.0);
  EXPECT_EQ(largestStep(render(thinWithShadowsOf(kThin)), render(kThin)), 0.0f);
}

/// Where the picture shows nothing there may be a shadow, and the other way round.
TEST_P(ShadowOpacity, reachesIntoWhatIsNotSeen) {
  TransferFunction unseen = reference::constantOpacity(0.0f, 0.5f), clear = kThick;
  unseen.shadowOpacity = kThick.opacity;
  clear.shadowOpacity = {{0.0f, 0.0f}};
  EXPECT_LE(largestDifference(ask(unseen), ask(kThick)), path_.technique == "stochastic" ? 0.5 : 1e-3);
  const auto points = somePoints();
  const auto answers = ask(clear);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (answers[i].lit && points[i].y > -1.19f) EXPECT_EQ(answers[i].transmittance, 1.0f) << "above the floor";
  Scene alone = scene(unseen);
  alone.meshes.clear();
  for (const glm::vec4& pixel : engineOf("buffer").render(alone).pixels) EXPECT_EQ(pixel, glm::vec4(0.0f));
  Scene lit = scene(clear);
  Scene without = lit;
  without.shadows.technique = "none";
  without.meshes.front().shadow.casts = lit.meshes.front().shadow.casts = false;
  EXPECT_LE(largestStep(engineOf("buffer").render(lit), engineOf("buffer").render(without)), 1e-5f);
  EXPECT_GT(largestStep(render(clear), render(kThick)), 0.05f);
}

INSTANTIATE_TEST_SUITE_P(Techniques, ShadowOpacity, ::testing::Range<std::size_t>(0, 4));

TEST(ShadowOpacityEverywhere, isWhatLightMeets) {
  const auto ask = [](const TransferFunction& transfer) {
    Scene scene = along(mapPath(), smokeScene(transfer), kMapSize, 0.01f);
    scene.shadows.toleranceMode = "everywhere";
    return query(mapPath(), scene, somePoints());
  };
  EXPECT_LE(largestDifference(ask(thinWithShadowsOf(kThick)), ask(kThick)), 1e-3);
}

TEST(ShadowOpacityChanges, areReasonsToBuildMaps) {
  const Scene scene = along(mapPath(), smokeScene(kThin), kMapSize, 0.01f);
  Scene changed = scene;
  engineOf("buffer").transmittance(scene, "key", {glm::vec3(0.0f)});
  changed.volumes.front().transfer.shadowOpacity = kThick.opacity;
  engineOf("buffer").transmittance(changed, "key", {glm::vec3(0.0f)});
  const auto reason = [] { return engineOf("buffer").stats().lights.front().maps.front().reason.substr(0, 20); };
  EXPECT_EQ(reason(), "transfer function of");
  changed.volumes.front().transfer.opacity = kThick.opacity;
  engineOf("buffer").transmittance(changed, "key", {glm::vec3(0.0f)});
  EXPECT_EQ(reason(), "") << "the picture's opacity does not concern light";
}

}  // namespace
}  // namespace cdsm::property
