// SPDX-License-Identifier: Apache-2.0
// Rasterization and sorting: the fragments of every pixel against rays in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "build/raster_pass.hpp"
#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"
#include "scene/view.hpp"
#include "screen_reference.hpp"

namespace cdsm::kernels {
namespace {

using reference::Random;

/// Corners are rounded to 1/256 pixel, after rounding of single precision: an edge moves by less than this, pixels.
constexpr double kEdge = 0.02;

struct Fragment {
  float depth;
  std::uint32_t triangle;
  bool behind;  ///< seen from behind
};

/// The fragments of every pixel of a view.
struct Layers {
  int width, height;
  std::vector<std::vector<Fragment>> pixels;  ///< row after row
  std::vector<std::string> reports;

  const std::vector<Fragment>& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
};

Layers rasterize(build::RasterPass& pass, const Scene& scene, const shared::ViewData& view) {
  build::DeviceScene onDevice(deviceOf());
  onDevice.update(scene);
  Layers result{view.width, view.height, std::vector<std::vector<Fragment>>(std::size_t(view.width) * view.height), {}};
  build::Layers& layers =
      pass.run(onDevice, onDevice.allObjects(), view, [&](const std::string& what) { result.reports.push_back(what); });
  const auto keys = layers.fragments.download();
  const auto ranges = layers.ranges.download();
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const std::size_t tile = std::size_t(y / 8) * view.tilesX + x / 8;
      const shared::uint2 range = ranges[tile * 64 + y % 8 * 8 + x % 8];
      for (std::size_t i = range.x + layers.view.initialCount; i < range.x + layers.view.initialCount + range.y; ++i) {
        const auto bits = std::uint32_t(keys[i] >> 32);
        float depth;
        std::memcpy(&depth, &bits, sizeof(depth));
        const auto facing = std::uint32_t(keys[i]);
        result.pixels[std::size_t(y) * view.width + x].push_back({depth, facing >> 1, (facing & 1u) != 0});
      }
    }
  return result;
}

Scene sceneOf(const MeshData& mesh) {
  Scene scene = reference::emptyScene();
  reference::addMesh(scene, mesh, reference::addMaterial(scene, glm::vec3(1.0f), 0.5f));
  return scene;
}

/// From (0, 0, 3) towards the origin, 60 degrees high.
shared::ViewData testView(int width, int height, float nearDepth = 1e-4f) {
  Camera camera;
  camera.position = {0.0f, 0.0f, 3.0f};
  camera.fov = 60.0f;
  return scene::cameraView(camera, width, height, nearDepth);
}

/// The pixel's fragments ascend in depth, those away from edges are the reference's, at its depth.
void expectPixel(const ScreenReference& reference, const std::vector<Fragment>& fragments, int x, int y) {
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const Fragment& f = fragments[i];
    if (i > 0) EXPECT_LE(fragments[i - 1].depth, f.depth) << "pixel " << x << ", " << y;
    const Meeting meeting = reference.meet(f.triangle, x, y);
    // the pieces of a clipped triangle share edges: none may cover a pixel twice, wherever it is
    EXPECT_TRUE(found.insert(f.triangle).second) << "triangle " << f.triangle << " twice in pixel " << x << ", " << y;
    EXPECT_TRUE(meeting.covers || meeting.edgePixels < kEdge)
        << "triangle " << f.triangle << " does not cover pixel " << x << ", " << y << ", its edges are "
        << meeting.edgePixels << " pixels away";
    if (meeting.covers && meeting.slant > 1e-3)
      EXPECT_NEAR(f.depth, meeting.depth, 1e-5 * (1.0 + meeting.depth) / meeting.slant)
          << "triangle " << f.triangle << ", pixel " << x << ", " << y;
  }
  for (std::size_t i = 0; i < reference.triangleCount(); ++i) {
    const Meeting meeting = reference.meet(i, x, y);
    if (meeting.covers && meeting.edgePixels > kEdge)
      EXPECT_EQ(found.count(i), 1u) << "triangle " << i << " is missing in pixel " << x << ", " << y;
  }
}

void expectExact(const Layers& layers, const MeshData& mesh, const shared::ViewData& view) {
  const ScreenReference reference(view, mesh);
  for (int y = 0; y < layers.height; ++y)
    for (int x = 0; x < layers.width && !::testing::Test::HasFailure(); ++x)
      expectPixel(reference, layers.at(x, y), x, y);
}

void addTriangle(reference::MeshParts& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const auto first = glm::uint(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.emplace_back(first, first + 1, first + 2);
}

glm::vec3 randomPoint(Random& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach), z = random.uniform(-reach, reach);
  return {float(x), float(y), float(z)};
}

/// Triangles of size about `size` in a cube of half width `reach` around the origin.
MeshData triangleSoup(int count, std::uint32_t seed, double reach, double size) {
  Random random(seed);
  reference::MeshParts mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 at = randomPoint(random, reach);
    const glm::vec3 a = at + randomPoint(random, size), b = at + randomPoint(random, size),
                    c = at + randomPoint(random, size);
    addTriangle(mesh, a, b, c);
  }
  return mesh;
}

class Rasterize : public ::testing::Test {
 protected:
  build::RasterPass pass_{deviceOf()};

  /// Mesa's llvmpipe ends the loops of a work item silently after 65535 iterations in all: long sorts stay unfinished.
  static bool endsLongLoops() { return deviceOf().description().name.find("llvmpipe") != std::string::npos; }

  void expectSoup(const MeshData& mesh, int width, int height, float nearDepth = 1e-4f) {
    const shared::ViewData view = testView(width, height, nearDepth);
    expectExact(rasterize(pass_, sceneOf(mesh), view), mesh, view);
  }
};

TEST_F(Rasterize, smallTrianglesMatchRays) { expectSoup(triangleSoup(1500, 1, 1.5, 0.1), 48, 40); }
TEST_F(Rasterize, largeTrianglesMatchRays) { expectSoup(triangleSoup(150, 2, 1.0, 2.0), 48, 40); }
TEST_F(Rasterize, trianglesOverManyTilesMatchRays) { expectSoup(triangleSoup(8, 3, 1.0, 1.5), 200, 120); }

TEST_F(Rasterize, oddViewSizesMatchRays) {
  const std::pair<int, int> sizes[] = {{1, 1}, {7, 13}, {65, 3}, {2, 90}, {8, 8}, {9, 16}};
  for (const auto& [width, height] : sizes) expectSoup(triangleSoup(300, 4, 1.5, 0.8), width, height);
}

/// Around the eye and through the near plane; most reach behind the eye.
TEST_F(Rasterize, trianglesThroughTheNearPlaneMatchRays) {
  for (const float nearDepth : {1e-3f, 0.1f, 2.9f}) expectSoup(triangleSoup(300, 5, 6.0, 5.0), 40, 32, nearDepth);
}

TEST_F(Rasterize, hugeTrianglesMatchRays) {
  reference::MeshParts mesh = reference::partsOf(triangleSoup(60, 6, 3.0, 3000.0));
  addTriangle(mesh, {-1e5f, -1e5f, -1.0f}, {1e5f, -1e5f, -1.0f}, {0.0f, 2e5f, -1.0f});
  expectSoup(mesh, 40, 32);
}

TEST_F(Rasterize, nothingBehindTheEyeIsSeen) {
  reference::MeshParts mesh = reference::partsOf(triangleSoup(200, 7, 1.0, 0.5));
  for (glm::vec3& p : mesh.positions) p.z += 4.6f;  // the eye is at z = 3
  const Layers layers = rasterize(pass_, sceneOf(mesh), testView(24, 24));
  for (const auto& pixel : layers.pixels) EXPECT_TRUE(pixel.empty());
}

TEST_F(Rasterize, anEmptySceneHasNoFragments) {
  const Layers layers = rasterize(pass_, reference::emptyScene(), testView(17, 9));
  for (const auto& pixel : layers.pixels) EXPECT_TRUE(pixel.empty());
}

TEST_F(Rasterize, trianglesWithoutAreaHaveNoFragments) {
  reference::MeshParts mesh;
  addTriangle(mesh, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  addTriangle(mesh, {-1, 0, 0}, {1, 0, 0}, {0, 0, 0});
  addTriangle(mesh, {0, 0, 0}, {0, 0, 1}, {0, 0, 2});
  const Layers layers = rasterize(pass_, sceneOf(mesh), testView(9, 9));
  for (const auto& pixel : layers.pixels) EXPECT_TRUE(pixel.empty());
}

/// A wavy sheet of many triangles across the whole view, jittered, wider than it.
MeshData sheet(int side, double half, std::uint32_t seed) {
  Random random(seed);
  reference::MeshParts mesh;
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) {
      const double jitter = 0.15 * 2.0 * half / side;  // of the edges; does not fold the sheet
      const double px = -half + 2.0 * half * x / side + random.uniform(-jitter, jitter);
      const double py = -half + 2.0 * half * y / side + random.uniform(-jitter, jitter);
      mesh.positions.emplace_back(float(px), float(py), float(random.uniform(-0.5, 0.5) * jitter));
    }
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto at = [&](int dx, int dy) { return glm::uint((y + dy) * (side + 1) + x + dx); };
      mesh.triangles.emplace_back(at(0, 0), at(1, 0), at(1, 1));
      mesh.triangles.emplace_back(at(0, 0), at(1, 1), at(0, 1));
    }
  return mesh;
}

TEST_F(Rasterize, aSheetCoversEveryPixelOnce) {
  for (const int side : {1, 3, 40, 150}) {
    const Layers layers = rasterize(pass_, sceneOf(sheet(side, 4.0, std::uint32_t(side))), testView(96, 80));
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 96; ++x)
        EXPECT_EQ(layers.at(x, y).size(), 1u) << "pixel " << x << ", " << y << ", " << side << " quads a side";
  }
}

/// The floor under the eye reaches from far in front to far behind: cut by the near plane and the guard band, its two
/// triangles still share their edge.
TEST_F(Rasterize, aClippedFloorCoversEveryPixelBelowTheHorizonOnce) {
  for (const float reach : {50.0f, 5000.0f, 500000.0f}) {
    const float below = 2e-6f * reach;  // as little as single precision tells from the eye's own height
    const MeshData mesh = reference::quadMesh({0.1f, -below, 3.0f}, {reach, 0.0f, 0.0f}, {0.0f, 0.0f, -reach});
    const float nearDepth = 1e-6f * 2.9f * reach;  // of lights, the nearer one: a part of the scene's diagonal
    const Layers layers = rasterize(pass_, sceneOf(mesh), testView(64, 64, nearDepth));
    for (int x = 0; x < 64 && !HasFailure(); ++x) {
      for (int y = 0; y < 31; ++y) EXPECT_TRUE(layers.at(x, y).empty()) << x << ", " << y;
      for (int y = 33; y < 64; ++y) EXPECT_EQ(layers.at(x, y).size(), 1u) << x << ", " << y << ", reach " << reach;
    }
  }
}

TEST_F(Rasterize, closedMeshesAreEnteredAndLeftEquallyOften) {
  const Layers layers = rasterize(pass_, sceneOf(reference::sphereMesh(1.2f, 90, 45, false)), testView(120, 100));
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 120; ++x) {
      int inside = 0;
      for (const Fragment& f : layers.at(x, y)) inside += f.behind ? -1 : 1;
      EXPECT_EQ(inside, 0) << "pixel " << x << ", " << y;
    }
}

TEST_F(Rasterize, fiveThousandLayersInAPixelAreSorted) {
  if (endsLongLoops()) GTEST_SKIP() << "llvmpipe ends long loops";
  const MeshData mesh = reference::stackMesh(5000, 1.0f, 0.0004f, 2.0f);  // from y = 1 down to -1
  Camera camera;
  camera.position = {0.0f, 3.0f, 0.0f};
  camera.up = {0.0f, 0.0f, 1.0f};
  camera.fov = 40.0f;
  const Layers layers = rasterize(pass_, sceneOf(mesh), scene::cameraView(camera, 9, 9, 1e-4f));
  for (const auto& pixel : layers.pixels) {
    ASSERT_EQ(pixel.size(), 5000u);
    for (std::size_t i = 0; i < pixel.size(); ++i) ASSERT_EQ(pixel[i].triangle / 2, i);
  }
}

TEST_F(Rasterize, fragmentsOfOneDepthAreInTheOrderOfTheirTriangles) {
  reference::MeshParts mesh;
  for (int i = 0; i < 100; ++i) addTriangle(mesh, {-9, -9, 0}, {9, -9, 0}, {0, 9, 0});
  const Layers layers = rasterize(pass_, sceneOf(mesh), testView(8, 8));
  for (const auto& pixel : layers.pixels) {
    ASSERT_EQ(pixel.size(), 100u);
    for (std::size_t i = 0; i < pixel.size(); ++i) EXPECT_EQ(pixel[i].triangle, i);
  }
}

TEST_F(Rasterize, twoHundredThousandTrianglesInOneTileMatchRays) {
  if (endsLongLoops()) GTEST_SKIP() << "llvmpipe ends long loops";
  const MeshData mesh = triangleSoup(200000, 8, 1.2, 0.3);
  const shared::ViewData view = testView(8, 8);
  const Layers layers = rasterize(pass_, sceneOf(mesh), view);
  const ScreenReference reference(view, mesh);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(3, 4), std::pair(7, 7)})
    expectPixel(reference, layers.at(x, y), x, y);
}

/// Images of up to 131072 rays a row: the guard band must not cut what can be seen.
TEST_F(Rasterize, veryWideViewsAreCoveredToTheirEnds) {
  reference::MeshParts mesh;
  addTriangle(mesh, {-1e6f, -1e6f, 0.0f}, {1e6f, -1e6f, 0.0f}, {0.0f, 1e6f, 0.0f});
  Camera camera;
  camera.position = {0.0f, 0.0f, 3.0f};
  camera.fov = 0.001f;
  const Layers layers = rasterize(pass_, sceneOf(mesh), scene::cameraView(camera, 131072, 1, 1e-4f));
  for (const int x : {0, 1, 40000, 65535, 65536, 98304, 131071}) EXPECT_EQ(layers.at(x, 0).size(), 1u) << x;
}

/// More screen triangles than there is room for: clipping by the near plane makes two of one.
TEST_F(Rasterize, roomGrowsForClippedTrianglesAndIsReported) {
  reference::MeshParts mesh;
  Random random(9);
  for (int i = 0; i < 600; ++i) {  // one corner behind the eye, two in front: quads
    const float x = float(random.uniform(-1.0, 1.0)), y = float(random.uniform(-1.0, 1.0));
    addTriangle(mesh, {x - 1.0f, y, 0.0f}, {x + 1.0f, y, 0.0f}, {x, y + 0.1f, 4.0f});
  }
  const shared::ViewData view = testView(16, 16, 0.01f);
  const Layers layers = rasterize(pass_, sceneOf(mesh), view);
  ASSERT_EQ(layers.reports.size(), 1u);
  EXPECT_NE(layers.reports[0].find("grown"), std::string::npos) << layers.reports[0];
  expectExact(layers, mesh, view);
  EXPECT_TRUE(rasterize(pass_, sceneOf(mesh), view).reports.empty()) << "the room is kept";
}

TEST_F(Rasterize, theSameTrianglesInAnyOrderGiveTheSameDepths) {
  reference::MeshParts mesh = reference::partsOf(triangleSoup(400, 10, 1.0, 1.0));
  const Layers first = rasterize(pass_, sceneOf(mesh), testView(33, 21));
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  const Layers second = rasterize(pass_, sceneOf(mesh), testView(33, 21));
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    ASSERT_EQ(first.pixels[i].size(), second.pixels[i].size());
    for (std::size_t k = 0; k < first.pixels[i].size(); ++k)
      EXPECT_EQ(first.pixels[i][k].depth, second.pixels[i][k].depth);
  }
}

/// A pass that ran out of memory once goes on working.
TEST_F(Rasterize, aViewThatDoesNotFitLeavesThePassUsable) {
  const MeshData mesh = triangleSoup(50, 11, 1.0, 1.0);
  build::DeviceScene onDevice(deviceOf());
  onDevice.update(sceneOf(mesh));
  const shared::ViewData huge = testView(2000000, 500000);
  EXPECT_THROW(pass_.run(onDevice, onDevice.allObjects(), huge, [](const std::string&) {}), DeviceError);
  expectSoup(mesh, 16, 16);
  EXPECT_TRUE(rasterize(pass_, reference::emptyScene(), testView(8, 8)).at(0, 0).empty());
}

}  // namespace
}  // namespace cdsm::kernels
