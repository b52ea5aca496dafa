// SPDX-License-Identifier: Apache-2.0
// Convex bodies against membership of points worked out from inverse matrices, and their surfaces against their
// volumes.
#include "cluster/convex_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/test_scenes.hpp"

namespace cdsm::cluster {
namespace {

using reference::Random;

constexpr int kBodies = 40;
constexpr int kPoints = 2000;
constexpr double kClose = 1e-7;  ///< points nearer than this to a border may be on either side of it

glm::dvec3 randomPoint(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// A parallelepiped: the unit cube in an affine frame.
struct Slanted {
  glm::dmat4 worldFromCube{1.0};

  explicit Slanted(Random& random) {
    do {
      for (int column = 0; column < 3; ++column) worldFromCube[column] = glm::dvec4(randomPoint(random, 1.5), 0.0);
    } while (std::abs(glm::determinant(glm::dmat3(worldFromCube))) < 0.2);
    worldFromCube[3] =
        glm::dvec4(randomPoint(random, 0.5) - glm::dvec3(worldFromCube * glm::dvec4(0.5, 0.5, 0.5, 0)), 1);
  }
  ConvexBody body() const {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(worldFromCube * glm::dvec4(i & 1, i >> 1 & 1, i >> 2, 1));
    return ConvexBody::hexahedron(corners);
  }
  double volume() const { return std::abs(glm::determinant(glm::dmat3(worldFromCube))); }

  /// Of the part of origin + s * way, s in [low, high], that is inside: its least and greatest s; low > high if none.
  std::pair<double, double> inside(const glm::dvec3& origin, const glm::dvec3& way, double low, double high) const {
    const glm::dmat4 cubeFromWorld = glm::inverse(worldFromCube);
    const glm::dvec3 o(cubeFromWorld * glm::dvec4(origin, 1.0)), w(cubeFromWorld * glm::dvec4(way, 0.0));
    for (int axis = 0; axis < 3; ++axis) {
      const double a = -o[axis] / w[axis], b = (1.0 - o[axis]) / w[axis];
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return {low, high};
  }
  bool contains(const glm::dvec3& p) const {
    const glm::dvec3 q(glm::inverse(worldFromCube) * glm::dvec4(p, 1.0));
    return std::min({q.x, q.y, q.z}) >= 0.0 && std::max({q.x, q.y, q.z}) <= 1.0;
  }
};

/// How far inside of all planes; negative outside.
double depthIn(const ConvexBody& body, const glm::dvec3& p) {
  double least = INFINITY;
  for (const HalfSpace& side : body.halfSpaces()) least = std::min(least, side.distance(p));
  return body.empty() ? -INFINITY : least;
}

/// By the divergence theorem, all polygons turned outwards.
double volumeOf(const ConvexBody& body) {
  double sum = 0.0;
  const std::vector<HalfSpace> sides = body.halfSpaces();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const ConvexBody::Polygon& polygon = body.polygons()[i];
    glm::dvec3 area(0.0);
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      area += 0.5 * glm::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    sum += glm::length(area) * sides[i].offset / 3.0;
  }
  return sum;
}

/// The body has the points of `contains`, and its polygons close around their volume.
template <class Contains>
void expectBody(const ConvexBody& body, Random& random, double reach, const Contains& contains) {
  int inside = 0;
  for (int i = 0; i < kPoints; ++i) {
    const glm::dvec3 p = randomPoint(random, reach);
    const double depth = depthIn(body, p);
    if (std::abs(depth) < kClose) continue;
    EXPECT_EQ(depth > 0.0, contains(p)) << p.x << " " << p.y << " " << p.z << ", depth " << depth;
    inside += depth > 0.0;
  }
  const double part = double(inside) / kPoints, all = 8.0 * reach * reach * reach;
  const double deviation = all * std::sqrt(std::max(part * (1.0 - part), 1.0 / kPoints) / kPoints);
  EXPECT_NEAR(volumeOf(body), all * part, 5.0 * deviation);
}

HalfSpace randomPlane(Random& random) { return halfSpace(glm::dvec3(random.direction()), randomPoint(random, 0.6)); }

TEST(ConvexBodies, HexahedraHaveTheirPoints) {
  Random random(1);
  for (int i = 0; i < kBodies; ++i) {
    const Slanted box(random);
    EXPECT_NEAR(volumeOf(box.body()), box.volume(), 1e-12);
    expectBody(box.body(), random, 2.0, [&](const glm::dvec3& p) { return box.contains(p); });
  }
}

/// A point is in the hull of a body and an apex iff the ray from the apex through it meets the body there or behind.
TEST(ConvexBodies, HullsWithAPoint) {
  Random random(2);
  for (int i = 0; i < kBodies; ++i) {
    const Slanted box(random);
    const glm::dvec3 apex = randomPoint(random, 3.0);
    expectBody(box.body().hullWith(apex), random, 3.0, [&](const glm::dvec3& p) {
      const auto [low, high] = box.inside(apex, p - apex, 1.0, INFINITY);
      return low <= high;
    });
  }
}

TEST(ConvexBodies, SweptAlongAVector) {
  Random random(3);
  for (int i = 0; i < kBodies; ++i) {
    const Slanted box(random);
    const glm::dvec3 way = randomPoint(random, 2.0);
    expectBody(box.body().sweptAlong(way), random, 4.0, [&](const glm::dvec3& p) {
      const auto [low, high] = box.inside(p, -way, 0.0, 1.0);
      return low <= high;
    });
  }
}

/// The steps of Alg. 4.3 one after another: hull, then cut by many planes.
TEST(ConvexBodies, ClippedHulls) {
  Random random(4);
  for (int i = 0; i < kBodies; ++i) {
    const Slanted box(random), limit(random);
    const glm::dvec3 apex = randomPoint(random, 3.0);
    ConvexBody body = box.body().hullWith(apex);
    body.clip(limit.body().halfSpaces());
    const HalfSpace first = randomPlane(random), second = randomPlane(random);
    body.clip({first, second});
    expectBody(body, random, 2.0, [&](const glm::dvec3& p) {
      const auto [low, high] = box.inside(apex, p - apex, 1.0, INFINITY);
      return low <= high && limit.contains(p) && first.distance(p) >= 0.0 && second.distance(p) >= 0.0;
    });
  }
}

scene::Bounds unitBox() {
  scene::Bounds bounds;
  bounds.add(glm::vec3(0.0f));
  bounds.add(glm::vec3(1.0f));
  return bounds;
}

TEST(ConvexBodies, PlanesThroughCornersEdgesAndSides) {
  const ConvexBody box = ConvexBody::box(unitBox());
  struct Cut {
    glm::dvec3 normal, point;
    double volume;
  };
  for (const Cut& cut :
       {Cut{{1, 1, 1}, {0, 0, 0}, 1.0}, Cut{{-1, -1, -1}, {0, 0, 0}, 0.0}, Cut{{1, 1, 0}, {0, 0, 0}, 1.0},
        Cut{{1, -1, 0}, {0, 0, 0}, 0.5}, Cut{{1, 0, 0}, {0, 0, 0}, 1.0}, Cut{{1, 0, 0}, {1, 0, 0}, 0.0},
        Cut{{1, 1, 1}, {1, 0, 0}, 5.0 / 6.0}, Cut{{-1, -1, -1}, {1, 0, 0}, 1.0 / 6.0},
        Cut{{0, 0, 1}, {0, 0, 0.25}, 0.75}, Cut{{1, 0, 0}, {2, 0, 0}, 0.0}}) {
    ConvexBody body = box;
    const HalfSpace plane = halfSpace(cut.normal, cut.point);
    body.clip({plane, plane});
    EXPECT_NEAR(body.empty() ? 0.0 : volumeOf(body), cut.volume, 1e-12)
        << cut.normal.x << cut.normal.y << cut.normal.z << " at " << cut.point.x;
    if (cut.volume == 0.0) EXPECT_TRUE(body.empty());
  }
}

TEST(ConvexBodies, NothingIsLeftOfDistantBoxes) {
  Random random(5);
  for (int i = 0; i < kBodies; ++i) {
    ConvexBody body = ConvexBody::box(unitBox());
    const glm::dvec3 normal(random.direction());
    body.clip(halfSpace(normal, 3.0 * normal + randomPoint(random, 0.2)));
    EXPECT_TRUE(body.empty());
    body.clip(halfSpace(normal, glm::dvec3(0.0)));
    EXPECT_TRUE(body.empty());
    EXPECT_TRUE(body.vertices().empty());
    EXPECT_FALSE(body.mayTouch({glm::dvec3(0.5)}, {}));
  }
}

TEST(ConvexBodies, HullsWithPointsInsideAndOnTheBorder) {
  const ConvexBody box = ConvexBody::box(unitBox());
  for (const glm::dvec3& apex : {glm::dvec3(0.5), glm::dvec3(0.0), glm::dvec3(0.5, 0.5, 0), glm::dvec3(0.5, 0, 0)})
    EXPECT_NEAR(volumeOf(box.hullWith(apex)), 1.0, 1e-12);
  EXPECT_NEAR(volumeOf(box.hullWith({2, 0, 0})), 1.0 + 1.0 / 3.0, 1e-12);  // in the planes of two sides
  EXPECT_NEAR(volumeOf(box.sweptAlong({0, 0, 2})), 3.0, 1e-12);
  EXPECT_NEAR(volumeOf(box.sweptAlong(glm::dvec3(0.0))), 1.0, 1e-12);
}

/// Bodies and boxes that have a point in common touch.
TEST(ConvexBodies, WhatHasACommonPointTouches) {
  Random random(6);
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    const Slanted first(random), second(random);
    const glm::dvec3 move(2.5 * glm::dvec3(random.direction()));
    ConvexBody body = first.body();
    std::vector<glm::dvec3> corners;
    for (int c = 0; c < 8; ++c)
      corners.push_back(glm::dvec3(second.worldFromCube * glm::dvec4(c & 1, c >> 1 & 1, c >> 2, 1)) + move);
    bool common = false;
    for (int p = 0; p < 200 && !common; ++p) {
      const glm::dvec4 q(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1), 1);
      common = first.contains(glm::dvec3(second.worldFromCube * q) + move);
    }
    std::vector<glm::dvec3> axes;
    for (const HalfSpace& side : ConvexBody::hexahedron(corners).halfSpaces()) axes.push_back(side.normal);
    const bool touches = body.mayTouch(corners, axes);
    if (common) EXPECT_TRUE(touches) << i;
    apart += !touches;
  }
  EXPECT_GT(apart, 50);
}

TEST(ConvexBodies, HullsInAPlane) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, -0.5));
  const glm::dvec3 u = glm::normalize(glm::cross(normal, glm::dvec3(0, 0, 1))), v = glm::cross(normal, u);
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& p : {glm::dvec2(0, 0), {2, 0}, {2, 1}, {0, 1}, {1, 0.5}, {1, 0}, {2, 0}})
    points.push_back(3.0 * normal + p.x * u + p.y * v);
  const std::vector<glm::dvec3> hull = hullInPlane(points, normal);
  EXPECT_EQ(hull.size(), 4u);
  glm::dvec3 area(0.0);
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) area += 0.5 * glm::cross(hull[i] - hull[0], hull[i + 1] - hull[0]);
  EXPECT_NEAR(glm::length(area), 2.0, 1e-12);
  for (const glm::dvec3& p : hull) EXPECT_NEAR(glm::dot(normal, p), 3.0, 1e-12);
  EXPECT_TRUE(hullInPlane({{0, 0, 3}, {2, 1, 3}, {4, 2, 3}}, {0, 0, 1}).empty());
}

}  // namespace
}  // namespace cdsm::cluster
