// SPDX-License-Identifier: Apache-2.0
// Coloured transmittance: laws that hold whatever the scene, closed forms per channel, and what it is refused for.
// random_scenes_test, tolerance_test and render_test hold it against the reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine_paths.hpp"
#include "io/points_file.hpp"
#include "light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 64;
constexpr float kTolerance = 0.01f;
const glm::vec3 kTransmission(0.9f, 0.5f, 0.0f);

std::vector<glm::vec3> somePoints(std::uint32_t seed) {
  reference::Random random(seed);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back(static_cast<float>(random.uniform(0.0, 1.8)) * random.direction());
  return points;
}

/// Every memory strategy, both formats of nodes, from buffers and from images; not all of their combinations.
std::vector<Path> colorPaths() {
  return {rayPath(),
          {"deep-shadow-map", "exact", "bilinear", "buffer", 1, "float32"},
          {"deep-shadow-map", "chunked", "bilinear", "buffer", 1, "unorm16"},
          {"deep-shadow-map", "tiled", "bilinear", "buffer", 1, "float32"},
          {"deep-shadow-map", "fixed", "bilinear", "buffer", 1, "unorm16"},
          {"deep-shadow-map", "atlas", "bilinear", "image", 1, "float32"},
          {"deep-shadow-map", "exact", "bilinear", "image", 1, "unorm16"}};
}

Scene colored(Scene scene) {
  scene.shadows.transmittance = "rgb";
  return scene;
}

/// A volume over a filled box over a translucent sheet, all with the same transmission, each wide enough for the cone.
Scene layers() {
  Scene scene = reference::emptyScene();
  scene.lights.front().type = LightType::Directional;
  scene.lights.front().direction = {0.0f, -1.0f, 0.0f};
  const int volume = reference::addVolume(scene,
                                          reference::makeVolume(VoxelType::UInt8, glm::uvec3(8), {-2.0f, 0.5f, -2.0f},
                                                                {2.0f, 1.5f, 2.0f}, [](const auto&) { return 1.0; }),
                                          reference::constantOpacity(0.4f, 1.0f));
  scene.volumes[std::size_t(volume)].transfer.transmission = {{0.0f, kTransmission}};
  const int box = reference::addMesh(scene, reference::boxMesh({-2.0f, -0.5f, -2.0f}, {2.0f, 0.0f, 2.0f}),
                                     reference::addMaterial(scene, glm::vec3(1.0f), 0.0f));
  scene.meshes[std::size_t(box)].interiorExtinction = 0.8f;
  scene.meshes[std::size_t(box)].interiorTransmission = kTransmission;
  const int glass = reference::addMaterial(scene, glm::vec3(1.0f), 1.0f);
  scene.materials[std::size_t(glass)].transmission = kTransmission;
  reference::addMesh(scene, reference::stackMesh(1, -1.0f, 1.0f, 2.0f), glass);
  return colored(scene);
}

glm::dvec3 exactBelow(double y) {
  const glm::dvec3 absorbed = 1.0 - glm::dvec3(kTransmission);
  const double volume = -std::log1p(-0.4) * glm::clamp(1.5 - y, 0.0, 1.0);
  const double box = 0.8 * glm::clamp(-y, 0.0, 0.5);
  const glm::dvec3 sheet = y < -1.0 ? 1.0 - absorbed : glm::dvec3(1.0);
  return glm::exp(-(volume + box) * absorbed) * sheet;
}

class Colors : public ::testing::TestWithParam<Path> {
 protected:
  void SetUp() override {
    if (!canFetch(GetParam().fetch)) GTEST_SKIP() << "the device has no images";
  }
  std::vector<Transmittance> ask(const Scene& scene, const std::vector<glm::vec3>& points) {
    return query(GetParam(), along(GetParam(), scene, kMapSize, kTolerance), points);
  }
};

TEST_P(Colors, areThoseOfTheFormula) {
  std::vector<glm::vec3> points;
  for (const float y : {1.8f, 1.2f, 0.7f, 0.2f, -0.1f, -0.4f, -0.8f, -1.4f}) points.emplace_back(0.1f, y, -0.2f);
  const std::vector<Transmittance> found = ask(layers(), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 exact = exactBelow(double(points[i].y));
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(found[i].color[channel], exact[channel], kTolerance + 1e-3) << points[i].y << ", " << channel;
    EXPECT_NEAR(found[i].transmittance, (exact.r + exact.g + exact.b) / 3.0, kTolerance + 1e-3);
  }
}

/// Nothing is coloured: three times the grey light, but for where the compression of three at once sets its nodes.
TEST_P(Colors, areAlikeWhereNothingHasATransmission) {
  const Scene scene = reference::randomScene(4);
  const std::vector<glm::vec3> points = somePoints(4);
  const std::vector<Transmittance> grey = ask(scene, points), rgb = ask(colored(scene), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(rgb[i].color.r, rgb[i].color.g);
    EXPECT_EQ(rgb[i].color.r, rgb[i].color.b);
    EXPECT_EQ(grey[i].color, glm::vec3(grey[i].transmittance));
    EXPECT_NEAR(rgb[i].transmittance, grey[i].transmittance, 2e-4);
  }
}

/// Channels that change places in the scene do so in the answers, to the last bit.
TEST_P(Colors, changePlacesWithTheirTransmissions) {
  Scene scene = reference::randomScene(3);
  reference::giveRandomTransmissions(scene, 3);
  const std::vector<glm::vec3> points = somePoints(3);
  const std::vector<Transmittance> before = ask(scene, points);
  const auto turn = [](glm::vec3& c) { c = {c.b, c.r, c.g}; };
  for (Material& material : scene.materials) turn(material.transmission);
  for (Mesh& mesh : scene.meshes) turn(mesh.interiorTransmission);
  for (Volume& volume : scene.volumes)
    for (auto& point : volume.transfer.transmission) turn(point.color);
  const std::vector<Transmittance> behind = ask(scene, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::vec3 turned = before[i].color;
    turn(turned);
    EXPECT_EQ(behind[i].color, turned);
  }
}

TEST_P(Colors, getThroughWhatLetsAllOfThemPass) {
  Scene scene = reference::randomScene(2);
  reference::giveRandomTransmissions(scene, 2);
  for (Material& material : scene.materials) material.transmission = glm::vec3(1.0f);
  for (Mesh& mesh : scene.meshes) mesh.interiorTransmission = glm::vec3(1.0f);
  for (Volume& volume : scene.volumes) volume.transfer.transmission = {{0.0f, glm::vec3(1.0f)}};
  for (const Transmittance& t : ask(scene, somePoints(2))) EXPECT_EQ(t.color, glm::vec3(t.lit ? 1.0f : 0.0f));
}

INSTANTIATE_TEST_SUITE_P(Paths, Colors, ::testing::ValuesIn(colorPaths()),
                         [](const auto& info) { return info.param.name(); });

/// By trilinear lookups between voxels, of which the centres are asked here.
TEST(ColorCache, knowsTheColorsAtVoxels) {
  Scene scene = along(mapPath("exact"), layers(), kMapSize, kTolerance);
  std::vector<glm::vec3> centers;
  for (int y = 0; y < 8; ++y) centers.emplace_back(0.25f, 0.5f + (float(y) + 0.5f) / 8.0f, -0.25f);
  const std::vector<Transmittance> wanted = engineOf("buffer").transmittance(scene, "key", centers);
  scene.shadows.cache = "volume";
  const std::vector<Transmittance> found = engineOf("buffer").transmittance(scene, "key", centers);
  EXPECT_GE(engineOf("buffer").stats().cache->bytes, 3u * 8u * 8u * 8u * 2u);
  for (std::size_t i = 0; i < centers.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(found[i].color[channel], wanted[i].color[channel], 2e-5) << i << ", " << channel;
  EXPECT_LT(found.front().color.b, 0.9f * found.front().color.r);
}

/// Photons of each colour of their own, which are stopped as their transmittance has it: within four deviations.
TEST(ColorPhotons, areRightInTheMean) {
  constexpr int kSeeds = 40;
  std::vector<glm::vec3> points;
  for (const float x : {-0.8f, 0.0f, 0.8f}) points.emplace_back(x, -1.4f, 0.3f);
  for (const bool stratified : {false, true}) {
    glm::dvec3 sum(0.0);
    for (int seed = 1; seed <= kSeeds; ++seed) {
      Scene scene = along({"stochastic", "chunked", "nearest", "buffer"}, layers(), 128, kTolerance);
      scene.shadows.seed = seed;
      scene.shadows.stratified = stratified;
      for (const Transmittance& t : engineOf("buffer").transmittance(scene, "key", points)) sum += glm::dvec3(t.color);
    }
    const double lookups = double(kSeeds) * double(points.size());
    const glm::dvec3 exact = exactBelow(-1.4);
    for (int channel = 0; channel < 3; ++channel) {
      const double deviation = std::sqrt(exact[channel] * (1.0 - exact[channel]) / (13.0 * lookups));
      EXPECT_NEAR(sum[channel] / lookups, exact[channel], 4.0 * deviation + 1e-6) << channel << ' ' << stratified;
    }
  }
}

/// What is grey casts grey noise: the photons of a texel share a number.
TEST(ColorPhotons, stayGreyWhereNothingHasATransmission) {
  for (const bool stratified : {false, true}) {
    Scene scene = along({"stochastic", "chunked", "bilinear", "buffer"}, reference::randomScene(1), 128, kTolerance);
    scene.shadows.transmittance = "rgb";
    scene.shadows.stratified = stratified;
    for (const Transmittance& t : engineOf("buffer").transmittance(scene, "key", somePoints(1))) {
      EXPECT_EQ(t.color.r, t.color.g);
      EXPECT_EQ(t.color.r, t.color.b);
    }
  }
}

TEST(ColorNodes, takeOneDepthAndThreeTransmittances) {
  for (const auto& [format, bytes] : {std::pair("float32", 16.0), std::pair("unorm16", 8.0)}) {
    Scene scene = along(mapPath("exact", "nearest"), layers(), kMapSize, kTolerance);
    scene.shadows.nodeFormat = format;
    const std::vector<LightMap> maps = engineOf("buffer").lightMaps(scene, "key");
    EXPECT_EQ(engineOf("buffer").stats().memory.bytesPerNode, bytes);
    ASSERT_EQ(maps.size(), 1u);
    ASSERT_EQ(maps[0].colors.size(), maps[0].nodes.size());
    for (std::size_t i = 0; i < maps[0].nodes.size(); ++i) {
      const glm::vec3& c = maps[0].colors[i];
      EXPECT_NEAR(maps[0].nodes[i].transmittance, (c.r + c.g + c.b) / 3.0f, 1e-6f);
      EXPECT_GE(c.r, c.b);
    }
    const std::uint32_t middle = maps[0].firstNode[std::size_t(maps[0].width * maps[0].height / 2 + 20) + 1];
    EXPECT_NEAR(maps[0].colors[middle - 1].g, exactBelow(-2.0).g, 1e-4) << "the function ends exactly";
  }
}

TEST(ColorNodes, areNotThereInGrey) {
  Scene scene = along(mapPath("exact", "nearest"), layers(), kMapSize, kTolerance);
  scene.shadows.transmittance = "grey";
  EXPECT_TRUE(engineOf("buffer").lightMaps(scene, "key").front().colors.empty());
}

/// Dense ones, which would hide all behind them if they were opaque to light, above a layer of small ones. Means over
/// points, as rays of texels and of points pass the edges of spheres otherwise.
TEST(ColorSpheres, letLightThroughToThoseBehind) {
  reference::SphereParts dense, small;
  for (int i = 0; i < 4900; ++i) {
    dense.centers.emplace_back(float(i % 70) / 24.0f - 1.45f, 0.5f, float(i / 70) / 24.0f - 1.45f);
    dense.radii.push_back(0.06f);
  }
  for (int i = 0; i < 4900; ++i) {
    small.centers.emplace_back(float(i % 70) / 28.0f - 1.25f, -0.5f, float(i / 70) / 28.0f - 1.25f);
    small.radii.push_back(0.018f);
  }
  Scene scene = reference::emptyScene();
  scene.lights.front().type = LightType::Directional;
  scene.lights.front().direction = {0.1f, -1.0f, 0.05f};
  for (const glm::vec3& transmission : {glm::vec3(0.97f, 0.95f, 0.9f), glm::vec3(0.1f, 0.2f, 0.3f)}) {
    scene.materials.push_back({"", glm::vec3(1.0f), glm::vec3(0.0f), 1.0f, 1.0f, transmission});
    reference::addSpheres(scene, transmission.r > 0.5f ? dense : small, int(scene.materials.size()) - 1);
  }
  std::vector<glm::vec3> points = somePoints(12);
  for (glm::vec3& point : points) point = {0.5f * point.x, -1.0f, 0.5f * point.z};
  const auto mean = [&](const Path& path) {
    glm::dvec3 sum(0.0);
    for (const Transmittance& t : query(path, along(path, colored(scene), 512, kTolerance), points))
      sum += glm::dvec3(t.color) / double(points.size());
    return sum;
  };
  const glm::dvec3 traced = mean(rayPath()), mapped = mean(mapPath("exact"));
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(mapped[channel], traced[channel], 0.02) << channel;
}

/// Maps are made anew when a transmission changes, or whether it counts.
TEST(ColorMaps, followTheirTransmissions) {
  Scene scene = along(mapPath("exact"), layers(), kMapSize, kTolerance);
  const auto reason = [&] {
    engineOf("buffer").transmittance(scene, "key", {glm::vec3(0.0f)});
    return engineOf("buffer").stats().lights.front().maps.front().reason;
  };
  reason();
  EXPECT_EQ(reason(), "");
  scene.materials.back().transmission.g = 0.3f;
  EXPECT_NE(reason(), "");
  scene.meshes.front().interiorTransmission.g = 0.3f;
  EXPECT_NE(reason(), "");
  scene.volumes.front().transfer.transmission.front().color.g = 0.3f;
  EXPECT_NE(reason(), "");
  scene.shadows.transmittance = "grey";
  EXPECT_NE(reason(), "");
}

TEST(ColorQueries, fillThreeValuesForEachPoint) {
  Engine& engine = engineOf("buffer");
  const Scene scene = along(mapPath("exact"), layers(), kMapSize, kTolerance);
  const std::vector<glm::vec3> points = somePoints(9);
  const std::vector<Transmittance> wanted = engine.transmittance(scene, "key", points);
  EXPECT_EQ(engine.channels(), 3u);
  std::vector<float> values(3 * points.size());
  engine.transmittance("key", points.data(), points.size(), values.data());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t channel = 0; channel < 3; ++channel)
      EXPECT_EQ(values[3 * i + channel], wanted[i].color[int(channel)]);
  std::ostringstream out;
  io::writeTransmittances(out, {glm::vec3(1, 2, 3)}, {{1, 0.5f, glm::vec3(1.0f, 0.5f, 0.0f)}},
                          io::LightColumns::Colors);
  EXPECT_EQ(out.str(), "x,y,z,lit,r,g,b\n1,2,3,1,1,0.5,0\n");
}

/// All of the light or none of it: no way to tell colours apart.
TEST(Colors, areRefusedByTechniquesWithoutThem) {
  for (const char* technique : {"shadow-map", "implicit-sphere"}) {
    Scene scene = layers();
    reference::addSpheres(scene, {{glm::vec3(0.0f)}, {0.1f}, {}}, 0);
    scene.shadows.technique = technique;
    EXPECT_THROW(validate(scene), Error) << technique;
    scene.shadows.transmittance = "grey";
    EXPECT_NO_THROW(validate(scene)) << technique;
  }
  Scene scene = layers();
  scene.shadows.technique = "shadow-rays";
  EXPECT_NO_THROW(validate(scene));
  scene.shadows.rays = "opaque";
  EXPECT_THROW(validate(scene), Error);
}

TEST(Colors, mustBeTransmissions) {
  const auto refused = [](auto change) {
    Scene scene = layers();
    change(scene);
    EXPECT_THROW(validate(scene), Error);
  };
  refused([](Scene& s) { s.shadows.transmittance = "red"; });
  refused([](Scene& s) { s.materials.front().transmission.r = 1.1f; });
  refused([](Scene& s) { s.meshes.front().interiorTransmission.g = -0.1f; });
  refused([](Scene& s) { s.volumes.front().transfer.transmission.front().color.b = NAN; });
  refused([](Scene& s) { s.volumes.front().transfer.transmission = {{1.0f, {}}, {0.0f, {}}}; });
}

}  // namespace
}  // namespace cdsm::property
