// SPDX-License-Identifier: Apache-2.0
// Coverage masks of single screen triangles against a point-in-triangle test in exact integers.
#include <gtest/gtest.h>

#include <algorithm>

#include "kernel_test.hpp"
#include "reference/test_scenes.hpp"
#include "shared/layer_data.h"

namespace cdsm::kernels {
namespace {

using shared::int2;
using shared::int4;
using shared::ScreenTriangle;
using Masks = device::Buffer<std::uint64_t>;

const char* const kText = R"(
#include "build/coverage.clh"
/// An item per triangle and tile; `boxes`: what coveredPixels says of each triangle.
__kernel void coverage(int2 view, int2 tiles, uint count, __global const ScreenTriangle* triangles,
                       __global ulong* masks, __global int4* boxes) {
  uint i = (uint)get_global_id(0);
  if (i >= count * (uint)(tiles.x * tiles.y)) return;
  __global const ScreenTriangle* t = &triangles[i / (uint)(tiles.x * tiles.y)];
  int tile = (int)(i % (uint)(tiles.x * tiles.y)), x = tile % tiles.x * CDSM_TILE, y = tile / tiles.x * CDSM_TILE;
  TriangleEdges edges = triangleEdges(t);
  masks[i] = coverageMask(&edges, x, y) & insideView(x, y, view.x, view.y);
  if (tile == 0) boxes[i / (uint)(tiles.x * tiles.y)] = coveredPixels(t->a, t->b, t->c, view.x, view.y);
}
)";

/// 128 bits, so that nothing here can overflow.
__int128 cross(int2 a, int2 b, int2 p) { return __int128(b.x - a.x) * (p.y - a.y) - __int128(b.y - a.y) * (p.x - a.x); }

/// The interior lies on the side where cross() is positive. A centre on an edge counts if the edge runs upwards (to
/// smaller y), or along y = constant to larger x.
bool insideOf(int2 a, int2 b, int2 p) {
  const __int128 side = cross(a, b, p);
  return side > 0 || (side == 0 && (b.y < a.y || (b.y == a.y && b.x > a.x)));
}

bool covers(const ScreenTriangle& t, int x, int y) {
  const int2 p{x * CDSM_SUBPIXELS + CDSM_SUBPIXELS / 2, y * CDSM_SUBPIXELS + CDSM_SUBPIXELS / 2};
  return insideOf(t.a, t.b, p) && insideOf(t.b, t.c, p) && insideOf(t.c, t.a, p);
}

/// Turned so that its area is positive; without area: empty.
void addTriangle(std::vector<ScreenTriangle>& triangles, int2 a, int2 b, int2 c) {
  const __int128 area = cross(a, b, c);
  if (area == 0) return;
  ScreenTriangle t{};
  t.a = a;
  t.b = area > 0 ? b : c;
  t.c = area > 0 ? c : b;
  triangles.push_back(t);
}

struct Coverage {
  int width, height, tilesX, tilesY;
  std::vector<std::uint64_t> masks;
  std::vector<int4> boxes;

  bool covered(std::size_t triangle, int x, int y) const {
    const std::size_t tile = std::size_t(y / 8) * tilesX + x / 8;
    return masks[triangle * tilesX * tilesY + tile] >> (y % 8 * 8 + x % 8) & 1u;
  }
};

Coverage coverage(const std::vector<ScreenTriangle>& triangles, int width, int height) {
  Coverage result{width, height, (width + 7) / 8, (height + 7) / 8, {}, {}};
  device::Device& device = deviceOf();
  const std::size_t items = triangles.size() * result.tilesX * result.tilesY;
  const auto input = device::Buffer<ScreenTriangle>::fromHost(device, triangles, "triangles");
  Masks masks(device, items, "masks");
  device::Buffer<int4> boxes(device, triangles.size(), "boxes");
  device::Kernel<int2, int2, std::uint32_t, device::Buffer<ScreenTriangle>, Masks, device::Buffer<int4>> kernel(
      device, testProgram(device, kText), "coverage");
  kernel({"coverage", {items}, {kGroup}}, int2{width, height}, int2{result.tilesX, result.tilesY},
         std::uint32_t(triangles.size()), input, masks, boxes);
  result.masks = masks.download();
  result.boxes = boxes.download();
  return result;
}

void expectExact(const std::vector<ScreenTriangle>& triangles, int width, int height) {
  const Coverage result = coverage(triangles, width, height);
  int wrong = 0;
  for (std::size_t i = 0; i < triangles.size() && wrong < 5; ++i) {
    const int4 box = result.boxes[i];
    for (int y = 0; y < result.tilesY * 8; ++y)
      for (int x = 0; x < result.tilesX * 8; ++x) {
        const bool expected = x < width && y < height && covers(triangles[i], x, y);
        const bool boxed = x >= box.x && x <= box.z && y >= box.y && y <= box.w;
        if (result.covered(i, x, y) == expected && (boxed || !expected)) continue;
        if (++wrong > 5) continue;
        const ScreenTriangle& t = triangles[i];
        ADD_FAILURE() << "pixel " << x << ", " << y << (expected ? " is not" : " is") << " covered by (" << t.a.x
                      << ", " << t.a.y << ") (" << t.b.x << ", " << t.b.y << ") (" << t.c.x << ", " << t.c.y
                      << ") / 256" << (boxed ? "" : ", it is outside of the box");
      }
  }
}

/// Corners on a grid of `grid` / 256 pixel, within `reach` pixels of the view.
std::vector<ScreenTriangle> randomTriangles(int count, std::uint32_t seed, int grid, int reach, int side) {
  reference::Random random(seed);
  std::vector<ScreenTriangle> triangles;
  const auto corner = [&] {
    const int low = -reach * 256 / grid, high = (side + reach) * 256 / grid;
    const int x = random.integer(low, high) * grid, y = random.integer(low, high) * grid;
    return int2{x, y};
  };
  for (int i = 0; i < count; ++i) addTriangle(triangles, corner(), corner(), corner());
  return triangles;
}

TEST(Coverage, ofRandomTrianglesIsExact) { expectExact(randomTriangles(1500, 1, 1, 4, 40), 40, 24); }

TEST(Coverage, ofCornersOnPixelCentresAndBordersIsExact) {
  expectExact(randomTriangles(1500, 2, 128, 2, 24), 24, 24);  // every other grid point is a centre
}

TEST(Coverage, ofHugeTrianglesIsExact) {
  expectExact(randomTriangles(400, 3, 1, 32700, 24), 24, 17);
  expectExact(randomTriangles(400, 4, 1, 2000, 24), 24, 17);
}

TEST(Coverage, ofSliversIsExact) {
  reference::Random random(5);
  std::vector<ScreenTriangle> slivers;
  for (int i = 0; i < 1500; ++i) {
    const int2 a{random.integer(-3000, 9000), random.integer(-3000, 9000)};
    const int2 b{random.integer(-3000, 9000), random.integer(-3000, 9000)};
    addTriangle(slivers, a, b, {b.x + random.integer(-3, 3), b.y + random.integer(-3, 3)});
  }
  expectExact(slivers, 23, 24);
}

TEST(Coverage, ofAxisParallelTrianglesIsExact) {
  std::vector<ScreenTriangle> triangles;
  for (int x = 0; x < 4096; x += 384)
    for (int y = 0; y < 4096; y += 384) {
      addTriangle(triangles, {x, y}, {4096 - x, y}, {x, 4096 - y});
      addTriangle(triangles, {x, y}, {x + 128, y}, {x + 128, y + 128});
    }
  expectExact(triangles, 16, 16);
}

TEST(Coverage, ofAFullyCoveringTriangleIsEveryPixelOfTheView) {
  std::vector<ScreenTriangle> triangles;
  addTriangle(triangles, {-8388608, -8388608}, {8388608, -8388608}, {0, 8388608});
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 13), std::pair(65, 3), std::pair(8, 8)}) {
    const Coverage result = coverage(triangles, width, height);
    for (int y = 0; y < result.tilesY * 8; ++y)
      for (int x = 0; x < result.tilesX * 8; ++x)
        EXPECT_EQ(result.covered(0, x, y), x < width && y < height)
            << width << " x " << height << ": " << x << ", " << y;
  }
}

/// Fans around common corners, some on pixel centres: inside of the outline every pixel belongs to exactly one
/// triangle.
TEST(Coverage, ofTrianglesThatShareEdgesIsOncePerPixel) {
  reference::Random random(6);
  for (int round = 0; round < 60; ++round) {
    const int grid = round % 3 == 0 ? 128 : 1, side = 16 * 256 / grid;
    const int2 middle{random.integer(1, side - 1) * grid, random.integer(1, side - 1) * grid};
    std::vector<int2> outline;
    for (int i = 0; i < 4; ++i) {
      const int2 ends[] = {{0, 0}, {4096, 0}, {4096, 4096}, {0, 4096}};
      const int2 from = ends[i], to = ends[(i + 1) % 4];
      std::vector<int> at{0};
      for (int k = 0; k < 5; ++k) at.push_back(random.integer(1, 31));
      std::sort(at.begin(), at.end());
      for (const int k : at) outline.push_back({from.x + (to.x - from.x) / 32 * k, from.y + (to.y - from.y) / 32 * k});
    }
    std::vector<ScreenTriangle> fan;
    for (std::size_t i = 0; i < outline.size(); ++i)
      addTriangle(fan, middle, outline[i], outline[(i + 1) % outline.size()]);
    const Coverage result = coverage(fan, 16, 16);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        int count = 0;
        for (std::size_t i = 0; i < fan.size(); ++i) count += result.covered(i, x, y);
        EXPECT_EQ(count, 1) << "pixel " << x << ", " << y << " of round " << round;
      }
  }
}

}  // namespace
}  // namespace cdsm::kernels
