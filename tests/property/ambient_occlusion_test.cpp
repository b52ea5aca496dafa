// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of spheres against rays through the whole hemisphere of each point, a closed form, and its laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine_paths.hpp"
#include "frames.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kSide = 64;

/// White spheres in ambient light alone: a pixel is what its point sees.
Scene whiteScene(SphereData data) {
  Scene scene = reference::emptyScene();
  scene.lights.clear();
  scene.shadows.technique = "none";
  scene.image.width = scene.image.height = kSide;
  scene.image.ambient = glm::vec3(1.0f);
  scene.camera.position = {0.3f, 0.8f, 5.0f};
  scene.camera.target = glm::vec3(0.0f);
  reference::addSpheres(scene, std::move(data), reference::addMaterial(scene, glm::vec3(1.0f), 1.0f));
  scene.ambientOcclusion.emplace();
  return scene;
}

/// A ball of spheres that overlap a little, as atoms do; none within `hollow` of its middle.
SphereData clump(int count, std::uint32_t seed, double hollow = 0.0) {
  reference::Random random(seed);
  reference::SphereParts data;
  for (int i = 0; i < count; ++i) {
    const double away = std::cbrt(random.uniform(hollow * hollow * hollow, 1.0));
    data.centers.push_back(float(away) * random.direction());
    data.radii.push_back(float(0.75 / std::cbrt(count) * random.uniform(0.8, 1.2)));
  }
  return data;
}

Image picture(const Scene& scene) { return engineOf("buffer").render(scene); }

struct SeenPoint {
  glm::dvec3 point, normal;
  double factor;  ///< in the picture
};

/// The nearest points of spheres in the picture, every so many pixels.
std::vector<SeenPoint> seenPoints(const Scene& scene, const reference::World& world, int every) {
  const Image image = picture(scene);
  std::vector<SeenPoint> points;
  for (int i = every / 2; i < kSide * kSide; i += every) {
    const reference::Ray ray = reference::cameraRay(scene, i % kSide + 0.5, int(i / kSide) + 0.5);
    std::vector<reference::Crossing> crossings;
    world.balls.front().addCrossings(ray, 0, crossings);
    if (crossings.empty()) continue;
    const auto nearest =
        *std::min_element(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    const glm::dvec3 point = ray.at(nearest.t);
    points.push_back({point, world.balls.front().normal(nearest, point), double(image.pixels[std::size_t(i)].x)});
  }
  return points;
}

/// Mean difference to the truth, and root of its mean square.
struct Errors {
  double bias, rms;
};

Errors errorsOf(const Scene& scene) {
  const reference::World world(scene);
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const SeenPoint& p : seenPoints(scene, world, 11)) {
    const double error = p.factor - reference::ambientSeen(world, p.point, p.normal, 10.0, 300);
    sum += error;
    squares += error * error;
    count += 1.0;
  }
  EXPECT_GT(count, 40.0);
  return {sum / count, std::sqrt(squares / count)};
}

TEST(AmbientOcclusion, isWhatRaysSay) {
  for (const int count : {30, 300, 3000}) {
    Scene scene = whiteScene(clump(count, 3));
    scene.ambientOcclusion->distance = 2.0f;
    const Errors errors = errorsOf(scene);
    EXPECT_LT(errors.rms, 0.085) << count;  // crevices between few large spheres are finer than cells
    EXPECT_LT(std::abs(errors.bias), 0.05) << count;
    scene.ambientOcclusion.reset();
    EXPECT_GT(errorsOf(scene).rms, 0.25) << count << ": they are dark in places";
  }
}

TEST(AmbientOcclusion, isNoneOfASphereAlone) {
  for (const int resolution : {0, 8, 50})
    for (const int directions : {4, 16, 64}) {
      Scene scene = whiteScene({{{0.1f, -0.05f, 0.02f}}, {1.1f}, {}});
      scene.ambientOcclusion->resolution = resolution;
      scene.ambientOcclusion->directions = directions;
      const reference::World world(scene);
      for (const SeenPoint& p : seenPoints(scene, world, 7))
        EXPECT_GE(p.factor, directions < 16 ? 0.9 : 0.99) << resolution << " cells, " << directions << " directions";
    }
}

/// A ball above a floor of small spheres: a point whose normal is `angle` from upwards sees (1 + cos(angle)) / 2.
TEST(AmbientOcclusion, aboveAFloorIsHalfOfOnePlusTheCosine) {
  reference::SphereParts data{{{0.0f, 0.4f, 0.0f}}, {0.4f}, {}};
  for (int i = -40; i <= 40; ++i)
    for (int k = -40; k <= 40; ++k)
      for (const float below : {0.05f, 0.1f}) {
        data.centers.emplace_back(0.08f * float(i), -below, 0.08f * float(k));
        data.radii.push_back(0.055f);
      }
  Scene scene = whiteScene(std::move(data));
  scene.camera.position = {0.0f, 0.6f, 3.0f};
  scene.camera.target = {0.0f, 0.4f, 0.0f};
  scene.camera.fov = 18.0f;
  const reference::World world(scene);
  int onBall = 0;
  for (const SeenPoint& p : seenPoints(scene, world, 5)) {
    if (std::abs(glm::length(p.point - glm::dvec3(0.0, 0.4, 0.0)) - 0.4) > 1e-4 || p.normal.y < -0.5) continue;
    EXPECT_NEAR(p.factor, 0.5 + 0.5 * p.normal.y, 0.12) << p.normal.y;
    ++onBall;
  }
  EXPECT_GT(onBall, 200);
}

TEST(AmbientOcclusion, leavesNothingInsideOfAClump) {
  reference::SphereParts data = reference::partsOf(clump(6000, 8, 0.25));
  for (float& radius : data.radii) radius *= 1.6f;  // without gaps
  Scene scene = whiteScene(std::move(data));
  scene.camera.position = {0.0f, 0.02f, 0.0f};
  scene.camera.target = {0.3f, 0.1f, -1.0f};
  for (const glm::vec4& pixel : picture(scene).pixels) EXPECT_LE(pixel.x, 0.05f);
}

TEST(AmbientOcclusion, isLikeTheMirrorOfItsMirrorImage) {
  reference::SphereParts data = reference::partsOf(clump(400, 5));
  Scene scene = whiteScene(data);
  const Image image = picture(scene);
  for (glm::vec3& center : data.centers) center.x = -center.x;
  scene.spheres.front().data = std::make_shared<const SphereData>(data);
  scene.camera.position.x = -scene.camera.position.x;
  const Image mirror = picture(scene);
  double sum = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float difference =
          image.pixels[std::size_t(y * kSide + x)].x - mirror.pixels[std::size_t(y * kSide + kSide - 1 - x)].x;
      EXPECT_LE(std::abs(difference), 0.15f) << x << " " << y;
      sum += double(std::abs(difference));
    }
  EXPECT_LE(sum / (kSide * kSide), 0.02);
}

/// Two spheres far out keep the box as it is.
TEST(AmbientOcclusion, growsWithTheSpheres) {
  reference::SphereParts data{{{0.0f, 0.0f, 0.0f}, {-9.0f, -9.0f, -9.0f}, {9.0f, 9.0f, 9.0f}}, {1.0f, 0.5f, 0.5f}, {}};
  Scene scene = whiteScene(data);
  scene.ambientOcclusion->resolution = 96;
  const Image alone = picture(scene);
  for (int i = 0; i < 40; ++i) {
    data.centers.emplace_back(0.35f * float(i % 8) - 1.3f, 1.7f, 0.5f * float(int(i / 8)) - 1.0f);
    data.radii.push_back(0.3f);
  }
  scene.spheres.front().data = std::make_shared<const SphereData>(data);
  scene.camera.up = {0.0f, 0.0f, -1.0f};
  scene.camera.position = {0.0f, -5.0f, 0.1f};
  const Image below = picture(scene);
  scene.camera.up = {0.0f, 1.0f, 0.0f};
  scene.camera.position = {0.3f, 0.8f, 5.0f};
  const Image under = picture(scene);
  int darker = 0;
  for (std::size_t i = 0; i < alone.pixels.size(); ++i) {
    if (alone.pixels[i].w <= 0.0f) continue;
    EXPECT_LE(under.pixels[i].x, alone.pixels[i].x + 1e-3f);
    darker += under.pixels[i].x < alone.pixels[i].x - 0.05f;
  }
  EXPECT_GT(darker, 200);
  EXPECT_GT(below.pixels[kSide / 2 * kSide + kSide / 2].x, 0.98f) << "what is above does not darken the underside";
}

TEST(AmbientOcclusion, reachesAsFarAsItsDistance) {
  reference::SphereParts data{{{0.0f, 0.0f, 0.0f}}, {0.2f}, {}};
  for (int i = 0; i < 200; ++i) {  // a wall in front of it
    data.centers.emplace_back(0.2f * float(i % 20) - 1.9f, 0.4f * float(int(i / 20)) - 1.8f, 2.0f);
    data.radii.push_back(0.25f);
  }
  Scene scene = whiteScene(std::move(data));
  scene.camera.position = {0.0f, 0.0f, 1.2f};
  scene.camera.target = glm::vec3(0.0f);
  scene.camera.fov = 8.0f;
  const auto factor = [&](float distance, float strength) {
    scene.ambientOcclusion->distance = distance;
    scene.ambientOcclusion->strength = strength;
    return picture(scene).pixels[kSide / 2 * kSide + kSide / 2].x;
  };
  EXPECT_GT(factor(0.3f, 1.0f), 0.98f);
  EXPECT_LT(factor(0.9f, 1.0f), 0.5f);
  EXPECT_GT(factor(0.9f, 0.05f), factor(0.9f, 1.0f) + 0.1f);
  EXPECT_EQ(factor(0.9f, 0.0f), 1.0f);
}

/// Also deep among spheres that are seen through others.
TEST(AmbientOcclusion, isNoneWithoutStrength) {
  Scene scene = whiteScene(clump(500, 7));
  scene.materials.front().opacity = 0.3f;
  scene.ambientOcclusion->strength = 0.0f;
  const Image none = picture(scene);
  scene.ambientOcclusion.reset();
  EXPECT_TRUE(sameBytes(none, picture(scene)));
}

TEST(AmbientOcclusion, hasTheSameBytesAgain) {
  const Scene scene = whiteScene(clump(500, 7));
  const Image first = Engine().render(scene), second = Engine().render(scene);
  EXPECT_TRUE(sameBytes(first, second));
}

/// Materials by what becomes of their surfaces: those of meshes stay as they are.
TEST(AmbientOcclusion, isOfAmbientLightOnSpheresThatReceiveAndByThoseThatCast) {
  Scene scene = whiteScene(clump(300, 2));
  const Image occluded = picture(scene);
  scene.spheres.front().shadow.receives = false;
  const Image all = picture(scene);
  EXPECT_GT(rmsDifference(all, occluded), 0.1);
  scene.spheres.front().shadow = {false, true, 1.0f};
  EXPECT_TRUE(sameBytes(picture(scene), all));
  scene.spheres.front().shadow = {};
  scene.image.ambient = glm::vec3(0.0f);
  scene.lights = {reference::keyLight()};
  const Image lit = picture(scene);
  scene.ambientOcclusion.reset();
  EXPECT_TRUE(sameBytes(picture(scene), lit));

  scene.image.ambient = glm::vec3(0.3f);
  scene.spheres.front().worldFromObject[3].y = -10.0f;  // out of the picture
  reference::addMesh(scene, reference::boxMesh(glm::vec3(-1.0f), glm::vec3(1.0f)), 0);
  const Image mesh = picture(scene);
  scene.ambientOcclusion.emplace();
  EXPECT_TRUE(sameBytes(picture(scene), mesh));
}

TEST(AmbientOcclusion, staysUntilSpheresOrSettingsChange) {
  Scene scene = whiteScene(clump(20, 4));
  const auto filled = [&] {
    picture(scene);
    return engineOf("buffer").stats().ambientOcclusion->filled;
  };
  filled();
  scene.camera.position.x += 0.5f;
  scene.materials.front().diffuse = glm::vec3(0.5f);
  scene.spheres.front().shadow.receives = false;
  EXPECT_FALSE(filled());
  scene.spheres.front().worldFromObject[3].x = 0.3f;
  EXPECT_TRUE(filled());
  scene.materials.front().opacity = 0.5f;
  EXPECT_TRUE(filled());
  scene.ambientOcclusion->directions = 8;
  EXPECT_TRUE(filled());
  scene.spheres.front().data = std::make_shared<const SphereData>(clump(21, 4));
  EXPECT_TRUE(filled());
  EXPECT_FALSE(filled());
  const OcclusionStats stats = *engineOf("buffer").stats().ambientOcclusion;
  EXPECT_EQ(stats.bytes, std::uint64_t(8 * stats.width) * std::uint64_t(stats.height * stats.depth));
  scene.materials.front().opacity = 0.0f;
  EXPECT_TRUE(filled());
  EXPECT_EQ(picture(scene).pixels.front().w, 0.0f);
  scene.ambientOcclusion.reset();
  picture(scene);
  EXPECT_FALSE(engineOf("buffer").stats().ambientOcclusion);
  scene.ambientOcclusion.emplace();
  scene.spheres.clear();
  EXPECT_THROW(picture(scene), Error);
}

}  // namespace
}  // namespace cdsm::property
