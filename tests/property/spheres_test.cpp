// SPDX-License-Identifier: Apache-2.0
// Spheres by every technique against closed forms: how much passes a row of them, where the edge of a shadow is; and
// which of their changes make maps anew.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_paths.hpp"
#include "light_frame.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 256;
constexpr float kTolerance = 0.002f;
constexpr double kRounding = 1e-5;

std::vector<Path> spherePaths() {
  std::vector<Path> paths;
  for (const Path& path : allPaths())
    if (path.fetch == "buffer") paths.push_back(path);
  paths.push_back({"deep-shadow-map", "fixed", "bilinear", "buffer"});
  paths.push_back(mapPath("chunked", "bilinear", 4));
  paths.push_back({"shadow-map", "chunked", "nearest", "buffer"});
  paths.push_back({"shadow-rays", "chunked", "opaque", "buffer"});
  paths.push_back({"implicit-sphere", "chunked", "bilinear", "buffer"});
  return paths;
}

/// Knows all or nothing.
bool isOpaque(const Path& path) {
  return path.technique == "shadow-map" || path.technique == "implicit-sphere" || path.filter == "opaque";
}

/// "opaque" in place of a filter: opaque rays.
Scene alongSpheres(const Path& path, const Scene& scene) {
  Scene result = along(path, scene, kMapSize, kTolerance);
  result.shadows.filter = path.filter == "nearest" ? "nearest" : "bilinear";
  result.shadows.rays = path.filter == "opaque" ? "opaque" : "exact";
  result.shadows.pcf = 0;
  result.shadows.maxNodes = 32;  // a row of ten crossings has twenty
  return result;
}

std::vector<Transmittance> ask(const Path& path, const Scene& scene, const std::vector<glm::vec3>& points) {
  return query(path, alongSpheres(path, scene), points);
}

class SphereForms : public ::testing::TestWithParam<std::size_t> {
 protected:
  Path path_ = spherePaths()[GetParam()];

  double allowed() const { return kRounding + (path_.technique == "deep-shadow-map" ? double(kTolerance) : 0.0); }
};

/// A row of spheres below each other under the light: k of them let (1 - opacity)^2k pass, and half a sphere one factor
/// less.
TEST_P(SphereForms, aRowOfSpheresLetsItsPowersPass) {
  for (const float opacity : {0.3f, 0.75f, 1.0f}) {
    Scene scene = reference::emptyScene();
    reference::SphereParts row;
    for (int i = 0; i < 5; ++i) {
      row.centers.emplace_back(0.0f, 2.0f - 0.8f * float(i), 0.0f);
      row.radii.push_back(0.2f + 0.03f * float(i));
    }
    reference::addSpheres(scene, row, reference::addMaterial(scene, glm::vec3(0.5f), opacity));
    std::vector<glm::vec3> points;
    std::vector<int> crossings;
    for (int i = 0; i < 5; ++i)
      for (const int half : {0, 1, 2}) {  // above, inside, below
        points.emplace_back(0.01f, 2.0f - 0.8f * float(i) + 0.38f * float(1 - half), -0.02f);
        crossings.push_back(2 * i + half);
      }
    const auto result = ask(path_, scene, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double exact = std::pow(1.0 - double(opacity), crossings[i]);
      if (isOpaque(path_)) exact = opacity > 0.5f && crossings[i] > 0 ? 0.0 : 1.0;
      EXPECT_NEAR(result[i].transmittance, exact, allowed()) << "opacity " << opacity << ", point " << i;
    }
  }
}

/// Points on a plane around the shadow of a sphere straight below the light, whose tangent cone meets the plane in a
/// circle: dark up to a texel's width inside of it, lit from a texel's width outside of it on.
TEST_P(SphereForms, theShadowOfASphereIsACircle) {
  const double height = 1.7, radius = 0.6;  // of the centre over the plane y = -1; the light is 5 above that
  const double distance = 5.0 - height, tangent = radius / std::sqrt(distance * distance - radius * radius);
  for (const float scale : {1.0f, 0.4f}) {
    Scene scene = reference::emptyScene();
    const glm::mat4 pose = glm::mat4(glm::dmat4(double(scale)));
    glm::mat4 similarity = pose;
    similarity[3] = {0.0f, 0.0f, 0.0f, 1.0f};
    reference::SphereParts data{{{0.0f, float(height - 1.0) / scale, 0.0f}}, {float(radius) / scale}, {}};
    reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 1.0f), similarity);
    const double circle = 5.0 * tangent, texel = LightFrame(scene, scene.lights.front(), kMapSize).texelAt(5.0);
    const double margin = path_.technique == "shadow-rays" ? 1e-4 : 1.5 * texel;
    std::vector<glm::vec3> inside, outside;
    for (int i = 0; i < 360; ++i) {
      const glm::dvec3 way(std::cos(i / 57.3), 0.0, std::sin(i / 57.3));
      inside.emplace_back((circle - margin) * way - glm::dvec3(0, 1, 0));
      outside.emplace_back((circle + margin) * way - glm::dvec3(0, 1, 0));
    }
    for (const Transmittance& t : ask(path_, scene, inside)) EXPECT_NEAR(t.transmittance, 0.0, allowed());
    for (const Transmittance& t : ask(path_, scene, outside)) EXPECT_NEAR(t.transmittance, 1.0, allowed());
  }
}

TEST_P(SphereForms, aLightInsideShinesThroughOneSide) {
  Scene scene = reference::emptyScene();
  scene.lights.front().type = LightType::Omni;
  scene.lights.front().position = {0.1f, 0.2f, -0.1f};
  reference::SphereParts data{{glm::vec3(0.0f)}, {1.0f}, {}};
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 0.4f));
  reference::Random random(5);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 200; ++i) points.push_back(random.direction() * (i % 2 ? 0.7f : 1.4f));
  const auto result = ask(path_, scene, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(result[i].transmittance, i % 2 || isOpaque(path_) ? 1.0 : 0.6, allowed()) << i;
}

TEST_P(SphereForms, thatCastNoShadowLetAllPass) {
  Scene scene = reference::emptyScene();
  reference::SphereParts data{{glm::vec3(0.0f), {1.0f, 0.0f, 0.0f}}, {0.5f, 0.4f}, {}};
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  scene.spheres.front().shadow.casts = false;
  EXPECT_EQ(ask(path_, scene, {{0.0f, -1.0f, 0.0f}}).front().transmittance, 1.0f);
  scene.spheres.front().shadow.casts = true;
  EXPECT_EQ(ask(path_, scene, {{0.0f, -1.0f, 0.0f}}).front().transmittance, 0.0f);
}

INSTANTIATE_TEST_SUITE_P(All, SphereForms, ::testing::Range<std::size_t>(0, spherePaths().size()),
                         [](const auto& instance) {
                           const Path path = spherePaths()[instance.param];
                           return path.name() + (isOpaque(path) ? path.filter : "");
                         });

/// A million spheres are spheres like others: through the gaps of a lattice all light passes, through a sphere none.
TEST(Spheres, aMillionOfThemInALattice) {
  constexpr int kSide = 100;
  reference::SphereParts data;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const glm::vec3 place(i % kSide, i / kSide % kSide, i / (kSide * kSide));
    data.centers.push_back((place + 0.5f) / float(kSide) * 2.0f - 1.0f);
    data.radii.push_back(0.0095f);
  }
  Scene scene = reference::emptyScene();
  reference::addSpheres(scene, std::move(data), reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  scene.lights.front().type = LightType::Directional;
  scene.lights.front().direction = {0.0f, -1.0f, 0.0f};
  std::vector<glm::vec3> points;  // below: in the middle of gaps, below centres
  for (int i = 1; i < kSide; i += 7)
    for (int k = 1; k < kSide; k += 7) {
      points.emplace_back(0.02f * float(i) - 1.0f, -1.1f, 0.02f * float(k) - 1.0f);
      points.push_back(points.back() + glm::vec3(0.01f, 0.0f, 0.01f));
    }
  for (const Path& path : {rayPath(), mapPath("chunked", "nearest")}) {
    const auto result = query(path, along(path, scene, 1024, kTolerance), points);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(result[i].transmittance, i % 2 ? 0.0f : 1.0f) << path.name() << " " << i;
  }
}

/// Which maps of light "key" the last query built anew, and why.
std::vector<std::string> reasonsOf(const Scene& scene) {
  engineOf("buffer").transmittance(scene, "key", {glm::vec3(0.0f)});
  std::vector<std::string> reasons;
  for (const MapStats& map : engineOf("buffer").stats().lights.front().maps) reasons.push_back(map.reason);
  return reasons;
}

TEST(Spheres, areInNewMapsWhenTheirShadowsChange) {
  const std::vector<std::string> kept{""}, moved{"object spheres0"};
  Scene scene = along(mapPath(), reference::emptyScene(), 64, 0.01f);
  reference::SphereParts data{{glm::vec3(0.0f), {1.0f, 0.0f, 0.0f}}, {0.5f, 0.4f}, {}};
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 0.5f));
  reasonsOf(scene);
  EXPECT_EQ(reasonsOf(scene), kept);
  scene.materials.front().diffuse = glm::vec3(0.1f);
  scene.spheres.front().shadow.receives = false;
  EXPECT_EQ(reasonsOf(scene), kept);
  scene.spheres.front().worldFromObject[3].x = 0.3f;
  EXPECT_EQ(reasonsOf(scene), moved);
  scene.materials.front().opacity = 0.6f;
  EXPECT_EQ(reasonsOf(scene), moved);
  data.radii.front() = 0.7f;
  scene.spheres.front().data = std::make_shared<const SphereData>(data);
  EXPECT_EQ(reasonsOf(scene), moved);
  EXPECT_EQ(reasonsOf(scene), kept);
  scene.spheres.front().name = "others";
  EXPECT_EQ(reasonsOf(scene), std::vector<std::string>{"objects"});
}

/// What stays on the device is not sent again.
TEST(Spheres, areUploadedOnce) {
  Engine engine;
  const auto uploads = [&](const Scene& scene) {
    engine.render(scene);
    std::uint64_t launches = 0;
    for (const KernelTime& kernel : engine.stats().kernels)
      launches += kernel.name == "upload spheres" ? kernel.launches : 0;
    return launches;
  };
  Scene scene = along(mapPath(), reference::emptyScene(), 64, 0.01f);
  scene.image.width = scene.image.height = 16;
  reference::SphereParts data{{glm::vec3(0.0f)}, {0.5f}, {}};
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 0.5f));
  EXPECT_EQ(uploads(scene), 1u);
  scene.spheres.front().worldFromObject[3].x = 0.3f;
  scene.materials.front().diffuse = glm::vec3(0.2f);
  EXPECT_EQ(uploads(scene), 0u);
  scene.spheres.front().data = std::make_shared<const SphereData>(data);
  EXPECT_EQ(uploads(scene), 1u);
}

}  // namespace
}  // namespace cdsm::property
