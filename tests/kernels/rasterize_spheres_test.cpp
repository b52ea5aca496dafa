// SPDX-License-Identifier: Apache-2.0
// Fragments of spheres against rays in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "build/raster_pass.hpp"
#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"
#include "scene/view.hpp"

namespace cdsm::kernels {
namespace {

using reference::Random;

struct Fragment {
  double depth;
  std::uint32_t sphere;
  bool leaving;
};
using Pixels = std::vector<std::vector<Fragment>>;  ///< row after row

glm::dvec3 xyz(const shared::float4& v) { return {v.x, v.y, v.z}; }

Pixels rasterize(const Scene& scene, const shared::ViewData& view) {
  build::DeviceScene onDevice(deviceOf());
  onDevice.update(scene);
  build::RasterPass pass(deviceOf());
  build::Layers& layers = pass.run(onDevice, onDevice.allObjects(), view, [](const std::string&) {});
  const auto keys = layers.fragments.download();
  const auto ranges = layers.ranges.download();
  Pixels pixels(std::size_t(view.width) * view.height);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const shared::uint2 range = ranges[(std::size_t(y / 8) * view.tilesX + x / 8) * 64 + y % 8 * 8 + x % 8];
      for (std::size_t i = range.x; i < range.x + range.y; ++i) {
        const auto bits = std::uint32_t(keys[i] >> 32), facing = std::uint32_t(keys[i]);
        float depth;
        std::memcpy(&depth, &bits, sizeof(depth));
        EXPECT_TRUE(facing & CDSM_SPHERE_BIT);
        pixels[std::size_t(y) * view.width + x].push_back(
            {depth, (facing & ~CDSM_SPHERE_BIT) >> 1, (facing & 1u) != 0});
      }
    }
  return pixels;
}

/// A pixel's ray in double precision.
struct ExactRay {
  glm::dvec3 origin, dir;

  ExactRay(const shared::ViewData& view, int x, int y)
      : origin(xyz(view.origin) + (x + 0.5) * xyz(view.originU) + (y + 0.5) * xyz(view.originV)),
        dir(xyz(view.dir) + (x + 0.5) * xyz(view.dirU) + (y + 0.5) * xyz(view.dirV)) {}
};

/// Where a ray and a sphere meet; `miss`: its distance from the surface over the radius, > 0 outside.
struct Meeting {
  double enter, leave, miss;
};

Meeting meet(const ExactRay& ray, const glm::dvec3& center, double radius) {
  const glm::dvec3 way = center - ray.origin;
  const double length = glm::length(ray.dir), middle = glm::dot(way, ray.dir) / (length * length);
  const double distance = glm::length(glm::cross(way, ray.dir)) / length;
  const double half = std::sqrt(std::max(radius * radius - distance * distance, 0.0)) / length;
  return {middle - half, middle + half, distance / radius - 1.0};
}

/// Rounding of centres, relative to what lies between them and the eye, and of outlines, moves an edge by less than
/// this part of a radius: `far` is the distance over the radius.
double slackOf(double far) { return 1e-6 * far + 1e-4; }

/// Every sphere of one opacity, in every pixel: its fragments, but for rays that graze it.
void expectExact(const SphereData& data, float opacity, const shared::ViewData& view) {
  Scene scene = reference::emptyScene();
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), opacity));
  const Pixels pixels = rasterize(scene, view);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width && !::testing::Test::HasFailure(); ++x) {
      const std::vector<Fragment>& found = pixels[std::size_t(y) * view.width + x];
      const ExactRay ray(view, x, y);
      std::size_t expected = 0, doubtful = 0;
      double wall = INFINITY;
      for (std::size_t i = 0; i < data.centers.size(); ++i) {
        const Meeting m = meet(ray, data.centers[i], data.radii[i]);
        const double far = glm::length(glm::dvec3(data.centers[i]) - ray.origin) / data.radii[i];
        for (const bool leaving : {false, true}) {
          const double depth = leaving ? m.leave : m.enter;
          const bool grazing = std::abs(m.miss) < slackOf(far) || std::abs(depth - view.nearDepth) < 1e-5;
          doubtful += grazing;
          if (grazing || m.miss > 0.0 || depth < view.nearDepth) continue;
          if (opacity >= 1.0f) wall = std::min(wall, depth);
          if (opacity >= 1.0f) continue;
          ++expected;
          const bool seen = std::any_of(found.begin(), found.end(), [&](const Fragment& f) {
            return f.sphere == i && f.leaving == leaving &&
                   std::abs(f.depth - depth) < 2e-3 * data.radii[i] + 2e-6 * depth;
          });
          EXPECT_TRUE(seen) << "sphere " << i << ", pixel " << x << ", " << y << ", depth " << depth;
        }
      }
      if (opacity < 1.0f) {
        EXPECT_GE(found.size(), expected) << x << ", " << y;
        EXPECT_LE(found.size(), expected + doubtful) << x << ", " << y;
      } else if (doubtful == 0) {
        ASSERT_EQ(found.size(), std::isinf(wall) ? 0u : 1u) << x << ", " << y;
        if (!found.empty()) EXPECT_NEAR(found[0].depth, wall, 2e-6 * wall + 1e-5) << x << ", " << y;
      }
      for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i - 1].depth, found[i].depth);
    }
}

/// From (0, 0, 3) towards the origin.
shared::ViewData testView(int width, int height, float fov = 60.0f, float nearDepth = 1e-4f) {
  Camera camera;
  camera.position = {0.0f, 0.0f, 3.0f};
  camera.fov = fov;
  return scene::cameraView(camera, width, height, nearDepth);
}

/// Parallel, through the origin.
shared::ViewData slantedView(int width, int height) {
  const glm::vec3 forward = glm::normalize(glm::vec3(1.0f, -2.0f, 0.5f));
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
  return scene::parallelView(-4.0f * forward, forward, right, 1.2f, 1.7f, width, height);
}

SphereData randomSpheres(int count, std::uint32_t seed, double reach, double least, double greatest) {
  Random random(seed);
  reference::SphereParts data;
  for (int i = 0; i < count; ++i) {
    data.centers.push_back(float(random.uniform(0.0, reach)) * random.direction());
    data.radii.push_back(float(least * std::pow(greatest / least, random.uniform(0.0, 1.0))));
  }
  return data;
}

TEST(RasterizeSpheres, matchRays) {
  for (const float opacity : {0.5f, 1.0f}) {
    expectExact(randomSpheres(300, 1, 1.5, 0.02, 0.3), opacity, testView(61, 43));
    expectExact(randomSpheres(20, 2, 1.5, 0.3, 1.0), opacity, testView(203, 120));
  }
}

/// Outlines at the borders of a wide view are long ellipses.
TEST(RasterizeSpheres, matchRaysInWideViews) {
  for (const float fov : {120.0f, 160.0f, 175.0f})
    for (const float opacity : {0.5f, 1.0f}) {
      expectExact(randomSpheres(200, 3, 4.0, 0.05, 0.5), opacity, testView(64, 64, fov));
      expectExact(randomSpheres(100, 4, 9.0, 0.5, 3.0), opacity, testView(64, 64, fov));
    }
}

/// Around the eye, behind it and through the near plane.
TEST(RasterizeSpheres, matchRaysAroundTheEye) {
  for (const float nearDepth : {1e-4f, 0.3f, 2.0f})
    for (const float opacity : {0.5f, 1.0f}) {
      reference::SphereParts data = reference::partsOf(randomSpheres(60, 5, 3.0, 0.1, 2.5));
      for (glm::vec3& center : data.centers) center.z += 2.5f;
      expectExact(data, opacity, testView(48, 48, 90.0f, nearDepth));
    }
}

TEST(RasterizeSpheres, matchParallelRays) {
  for (const float opacity : {0.5f, 1.0f})
    expectExact(randomSpheres(200, 6, 1.5, 0.02, 0.6), opacity, slantedView(70, 50));
}

/// A thousand radii and more from the eye: what is left of squared lengths there would be rounding.
TEST(RasterizeSpheres, matchRaysFarAway) {
  reference::SphereParts data = reference::partsOf(randomSpheres(400, 7, 2.0, 0.1, 0.4));
  for (glm::vec3& center : data.centers) center.z -= 500.0f;
  expectExact(data, 0.5f, testView(64, 64, 0.4f));
}

TEST(RasterizeSpheres, theirRoomIsCounted) {
  reference::SphereParts data =
      reference::partsOf(randomSpheres(60000, 8, 0.5, 0.2, 0.3));  // all of them in most pixels
  Scene scene = reference::emptyScene();
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  for (const auto& pixel : rasterize(scene, testView(16, 16, 20.0f))) EXPECT_EQ(pixel.size(), 1u);
}

/// So many that some of them are drawn first, to pass over what they hide.
constexpr int kMany = 6000;

TEST(RasterizeSpheres, matchRaysWhereMostAreHidden) {
  expectExact(randomSpheres(kMany, 9, 1.5, 0.02, 0.3), 1.0f, testView(61, 43));
  expectExact(randomSpheres(kMany, 10, 3.5, 0.05, 0.6), 1.0f, testView(40, 40, 150.0f));
  expectExact(randomSpheres(kMany, 11, 1.5, 0.02, 0.1), 1.0f, slantedView(70, 50));
  expectExact(randomSpheres(kMany, 12, 1.5, 0.002, 0.01), 1.0f, testView(61, 43));
}

/// Walls are never nearer than what is seen, and most tiles have one that is not much farther.
TEST(RasterizeSpheres, wallsAreBehindWhatIsSeen) {
  const SphereData data = randomSpheres(kMany, 13, 1.0, 0.08, 0.12);
  Scene scene = reference::emptyScene();
  reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(0.5f), 1.0f));
  build::DeviceScene onDevice(deviceOf());
  onDevice.update(scene);
  build::SphereWalls pass(deviceOf());
  for (const shared::ViewData& view : {testView(64, 64, 30.0f), slantedView(64, 64)}) {
    pass.run(onDevice, onDevice.allObjects(), view);
    const std::vector<float> walls = pass.tiles().download();
    int near = 0;
    for (int tile = 0; tile < view.tilesX * view.tilesY; ++tile) {
      double farthest = 0.0;
      for (int pixel = 0; pixel < CDSM_TILE_PIXELS; ++pixel) {
        const ExactRay ray(view, tile % view.tilesX * 8 + pixel % 8, int(tile / view.tilesX) * 8 + int(pixel / 8));
        double nearest = INFINITY;
        for (std::size_t i = 0; i < data.centers.size(); ++i) {
          const Meeting m = meet(ray, data.centers[i], data.radii[i]);
          if (m.miss <= 0.0) nearest = std::min(nearest, m.enter);
        }
        farthest = std::max(farthest, nearest);
      }
      EXPECT_GE(double(walls[std::size_t(tile)]), farthest * (1.0 - 1e-6)) << tile;
      near += double(walls[std::size_t(tile)]) < farthest + 0.3;
    }
    EXPECT_GT(near, 15) << "tiles with a wall";
  }
}

TEST(RasterizeSpheres, lieBeforeAndBehindTriangles) {
  Scene scene = reference::emptyScene();
  const int clear = reference::addMaterial(scene, glm::vec3(0.5f), 0.5f);
  reference::addMesh(scene, reference::quadMesh(glm::vec3(0.0f), {2, 0, 0}, {0, 2, 0}), clear);
  reference::addSpheres(scene, {{{0, 0, 1}, {0, 0, 0}, {0, 0, -1}}, {0.2f, 0.2f, 0.2f}, {}}, clear);
  build::DeviceScene onDevice(deviceOf());
  onDevice.update(scene);
  build::RasterPass pass(deviceOf());
  build::Layers& layers = pass.run(onDevice, onDevice.allObjects(), testView(1, 1), [](const std::string&) {});
  const auto keys = layers.fragments.download();
  const shared::uint2 range = layers.ranges.download()[0];
  ASSERT_EQ(range.y, 7u);
  std::vector<std::uint32_t> spheres;
  for (std::size_t i = range.x; i < range.x + range.y; ++i) {
    const auto facing = std::uint32_t(keys[i]);
    spheres.push_back(facing & CDSM_SPHERE_BIT ? (facing & ~CDSM_SPHERE_BIT) : 99u);
  }
  EXPECT_EQ(spheres, (std::vector<std::uint32_t>{0, 1, 2, 99, 3, 4, 5}));
}

}  // namespace
}  // namespace cdsm::kernels
