// SPDX-License-Identifier: Apache-2.0
// Implicit sphere shadow maps against every sphere of the scene, and the penumbra of one against its formula.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine_paths.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

const Path kPath{"implicit-sphere", "chunked", "bilinear", "buffer"};

/// [Krone 2017, §3.2]: s, b, x.
struct Softness {
  double reach = 0.0, distance = 1.0, exponent = 1.0;
};

/// What one sphere lets pass from `p` along the unit vector `dir` over `length`.
double throughSphere(const glm::dvec3& p, const glm::dvec3& dir, double length, const glm::dvec3& center, double radius,
                     const Softness& soft) {
  const glm::dvec3 way = center - p;
  const double along = glm::dot(way, dir), gap = glm::length(glm::cross(way, dir)) - radius;
  if (gap <= 0.0) {
    const double half = std::sqrt(std::max(-gap * (2.0 * radius + gap), 0.0));
    const bool before = along + half <= 0.0, behind = along - half >= length;
    const bool around = along - half <= 0.0 && along + half >= length;
    return before || behind || around ? 1.0 : 0.0;
  }
  if (along <= 0.0 || along >= length) return 1.0;
  const double part = 3.0 * (1.0 - std::min(along / soft.distance, 1.0));
  const double width = soft.reach * std::exp(-part * part / 2.0);
  return gap < width ? 1.0 - std::pow(1.0 - gap / width, soft.exponent) : 1.0;
}

/// The darkest of all spheres.
double throughAll(const Scene& scene, const glm::dvec3& p, const Softness& soft = {}) {
  const Light& light = scene.lights.front();
  const bool parallel = light.type == LightType::Directional;
  const glm::dvec3 way = parallel ? -glm::dvec3(light.direction) : glm::dvec3(light.position) - p;
  const double length = parallel ? INFINITY : glm::length(way);
  double t = 1.0;
  for (const Spheres& spheres : scene.spheres)
    for (std::size_t i = 0; i < spheres.data->centers.size(); ++i)
      t = std::min(t, throughSphere(p, glm::normalize(way), length, glm::dvec3(spheres.data->centers[i]),
                                    spheres.data->radii[i], soft));
  return t;
}

std::vector<Transmittance> ask(const Scene& scene, const std::vector<glm::vec3>& points, int mapSize) {
  return query(kPath, along(kPath, scene, mapSize, 0.01f), points);
}

/// The key light above, of any type.
void setLight(Scene& scene, LightType type) {
  Light& light = scene.lights.front();
  light.type = type;
  light.position = {0.4f, 5.0f, 0.3f};
  light.target = glm::vec3(0.0f);
  light.direction = {-0.3f, -1.0f, 0.2f};
  light.cutoff = 30.0f;
}

Scene sceneOf(SphereData data, LightType type) {
  Scene scene = reference::emptyScene();
  setLight(scene, type);
  reference::addSpheres(scene, std::move(data), reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  return scene;
}

constexpr LightType kTypes[] = {LightType::Directional, LightType::Spot, LightType::Omni};

/// Points on the spheres themselves, a little off them, on a floor below and anywhere among them.
std::vector<glm::vec3> pointsAround(const SphereData& data, reference::Random& random) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 2000; ++i) {
    const auto sphere =
        std::min(std::size_t(random.uniform(0.0, double(data.centers.size()))), data.centers.size() - 1);
    points.push_back(data.centers[sphere] + 1.001f * data.radii[sphere] * random.direction());
    points.emplace_back(random.uniform(-1.5, 1.5), -1.3, random.uniform(-1.5, 1.5));
    points.emplace_back(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  }
  return points;
}

class ImplicitSphere : public ::testing::TestWithParam<LightType> {};

/// A packing like that of molecules.
TEST_P(ImplicitSphere, answersAsEverySphereWould) {
  reference::Random random(11);
  reference::SphereParts data;
  for (int i = 0; i < 3000; ++i) {
    data.centers.push_back(static_cast<float>(std::cbrt(random.uniform(0.0, 1.0))) * random.direction());
    data.radii.push_back(float(random.uniform(0.03, 0.06)));
  }
  const auto points = pointsAround(data, random);
  const Scene scene = sceneOf(std::move(data), GetParam());
  const auto found = ask(scene, points, 1024);
  int alike = 0, lit = 0, asked = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!found[i].lit) continue;
    const double exact = throughAll(scene, points[i]);
    ++asked;
    alike += std::abs(exact - double(found[i].transmittance)) < 0.5;
    lit += exact > 0.5;
  }
  EXPECT_GE(alike, 0.995 * asked);
  EXPECT_GT(lit, asked / 10);
  EXPECT_LT(lit, asked * 9 / 10);
  EXPECT_GT(asked, 4000);
}

/// Across the penumbra below one sphere, by the paper's formula; none where the softness is 0.
TEST_P(ImplicitSphere, hasThePenumbraOfTheFormula) {
  Scene scene = sceneOf({{{0.0f, 1.0f, 0.0f}}, {0.3f}, {}}, GetParam());
  std::vector<glm::vec3> points;
  for (int i = 0; i < 400; ++i) points.emplace_back(-2.0f + 0.01f * float(i), -0.7f - 0.001f * float(i), 0.03f);
  for (const Softness& soft : {Softness{0.0, 1.0, 1.0}, Softness{0.1, 1.0, 1.0}, Softness{0.25, 3.0, 2.5}}) {
    scene.shadows.patch = ShadowSettings::kPatchAuto;
    scene.shadows.softness = float(soft.reach);
    scene.shadows.softnessDistance = float(soft.distance);
    scene.shadows.softnessExponent = float(soft.exponent);
    const auto found = ask(scene, points, 128);
    int partly = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!found[i].lit) continue;
      EXPECT_NEAR(found[i].transmittance, throughAll(scene, points[i], soft), 2e-3) << soft.reach << ", point " << i;
      partly += found[i].transmittance > 0.0f && found[i].transmittance < 1.0f;
    }
    EXPECT_EQ(partly > 5, soft.reach > 0.0) << partly;
  }
}

/// Each a third of a texel wide or less, two texels apart or more: all of them cast a shadow.
TEST_P(ImplicitSphere, losesNoSphereThatIsSmallerThanATexel) {
  reference::SphereParts data;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      data.centers.emplace_back(0.08f * float(i) - 0.8f, 0.003f * float(i * k % 17), 0.08f * float(k) - 0.8f);
      data.radii.push_back(0.001f);
    }
  Scene scene = sceneOf(data, GetParam());
  std::vector<glm::vec3> points;
  const Light& light = scene.lights.front();
  for (const glm::vec3& center : data.centers) {
    const bool parallel = light.type == LightType::Directional;
    points.push_back(center + 0.5f * glm::normalize(parallel ? light.direction : center - light.position));
  }
  for (const Transmittance& t : ask(scene, points, 256)) EXPECT_EQ(t.transmittance, 0.0f);
}

/// Spheres of several sets, each with maps of its own, and a penumbra across the sides of an omni light.
TEST_P(ImplicitSphere, joinsMapsOfClustersAndSides) {
  Scene scene = sceneOf({{{0.0f, 0.5f, 0.0f}, {2.0f, 1.5f, 0.3f}}, {0.3f, 0.2f}, {}}, GetParam());
  reference::addSpheres(scene, {{{0.3f, -0.3f, 0.2f}, {-0.9f, 1.0f, -0.4f}}, {0.2f, 0.4f}, {}}, 0);
  scene.shadows.softness = 0.2f;
  scene.shadows.patch = ShadowSettings::kPatchAuto;
  std::vector<glm::vec3> points;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k) points.emplace_back(0.1f * float(i) - 1.5f, -1.0f, 0.1f * float(k) - 3.0f);
  Path path = kPath;
  for (const int clusters : {1, 4}) {
    path.clusters = clusters;
    const auto found = query(path, along(path, scene, 64, 0.01f), points);
    int shadowed = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!found[i].lit) continue;
      EXPECT_NEAR(found[i].transmittance, throughAll(scene, points[i], {0.2, 1.0, 1.0}), 5e-3) << "point " << i;
      shadowed += found[i].transmittance < 1.0f;
    }
    EXPECT_GT(shadowed, 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, ImplicitSphere, ::testing::ValuesIn(kTypes));

/// What is drawn: nothing shadows itself, and neither do neighbours that are met at the edge of a texel.
TEST(ImplicitSphereImage, isThatOfShadowRays) {
  reference::Random random(4);
  reference::SphereParts data;
  for (int i = 0; i < 200; ++i) {
    data.centers.push_back(static_cast<float>(random.uniform(0.0, 1.0)) * random.direction());
    data.radii.push_back(float(random.uniform(0.05, 0.25)));
  }
  for (const LightType type : kTypes) {
    Scene scene = sceneOf(data, type);
    scene.image.width = 90;
    scene.image.height = 60;
    reference::addMesh(scene, reference::quadMesh({0.0f, -1.2f, 0.0f}, {3.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 3.0f}),
                       reference::addMaterial(scene, glm::vec3(0.8f), 1.0f));
    const Image exact = engineOf("buffer").render(along(rayPath(), scene, 1024, 0.01f));
    scene.shadows.bias = 1e-9f;  // less than rounding: a sphere knows itself without
    const Image image = engineOf("buffer").render(along(kPath, scene, 1024, 0.01f));
    int differing = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
      differing += glm::length(image.pixels[i] - exact.pixels[i]) > 0.02f;
    EXPECT_LE(differing, int(exact.pixels.size() / 400));
  }
}

TEST(ImplicitSphereCasters, areSpheresAlone) {
  Scene scene = sceneOf({{glm::vec3(0.0f)}, {0.5f}, {}}, LightType::Directional);
  scene.lights.front().direction = {0.0f, -1.0f, 0.0f};
  reference::addMesh(scene, reference::quadMesh({0.0f, 1.0f, 0.0f}, {3.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 3.0f}), 0);
  reference::addVolume(scene,
                       reference::makeVolume(VoxelType::UInt8, glm::uvec3(4), glm::vec3(-2.0f), glm::vec3(2.0f),
                                             [](const glm::dvec3&) { return 200.0; }),
                       reference::constantOpacity(0.9f, 0.1f));
  const std::vector<glm::vec3> points{{0.0f, -1.0f, 0.0f}, {1.0f, -1.0f, 0.0f}};
  const auto opaque = ask(scene, points, 64);
  EXPECT_EQ(opaque[0].transmittance, 0.0f);
  EXPECT_EQ(opaque[1].transmittance, 1.0f);
  scene.materials.front().opacity = 0.5f;  // not over the threshold
  EXPECT_EQ(ask(scene, points, 64)[0].transmittance, 1.0f);
  scene.spheres.clear();
  EXPECT_THROW(ask(scene, points, 64), Error);
}

TEST(ImplicitSphereMaps, stayWhenOnlyLookupsChange) {
  Scene scene = along(kPath, sceneOf({{glm::vec3(0.0f)}, {0.5f}, {}}, LightType::Spot), 64, 0.01f);
  const auto reason = [&] {
    engineOf("buffer").transmittance(scene, "key", {glm::vec3(0.0f)});
    return engineOf("buffer").stats().lights.front().maps.front().reason;
  };
  reason();
  scene.shadows.patch = 2;
  scene.shadows.softness = 0.1f;
  scene.shadows.softnessDistance = 2.0f;
  scene.shadows.tolerance = 0.02f;
  EXPECT_EQ(reason(), "");
  scene.shadows.threshold = 0.6f;
  EXPECT_EQ(reason(), "settings");
  EXPECT_EQ(engineOf("buffer").stats().memory.bytesUsed, 64u * 64u * 16u);
}

}  // namespace
}  // namespace cdsm::property
