// SPDX-License-Identifier: Apache-2.0
// The square of the light space perspective: what matters lies in it, wherever camera and light are; Wimmer's formula
// where camera and light are at right angles.
#include "cluster/light_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cluster_parts.hpp"

namespace cdsm::cluster {
namespace {

using reference::Random;

scene::Bounds boxOf(const glm::vec3& half) {
  scene::Bounds bounds;
  bounds.add(-half);
  bounds.add(half);
  return bounds;
}

Camera cameraAt(const glm::vec3& position, const glm::vec3& target, float fov = 45.0f) {
  Camera camera;
  camera.position = position;
  camera.target = target;
  camera.fov = fov;
  const glm::vec3 forward = glm::normalize(target - position);
  if (std::abs(forward.y) > 0.99f) camera.up = {1, 0, 0};
  return camera;
}

glm::dvec3 randomIn(const ConvexBody& body, Random& random) {
  const std::vector<glm::dvec3> corners = body.vertices();
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double weight = random.uniform(0.0, 1.0);
    sum += weight * corners[std::size_t(random.integer(0, int(corners.size()) - 1))];
    weights += weight;
  }
  return sum / weights;
}

struct Situation {
  std::string name;
  Camera camera;
  Light light;
};

/// Lights of one type where a light may be as seen by a camera at (0, 1, 6).
std::vector<Situation> situations() {
  const Camera camera = cameraAt({0, 1, 6}, {0, 0, 0});
  return {{"across", camera, spotAt({0, 6, 0}, {0, 0, 0}, 30)},
          {"along", camera, spotAt({0, 2, 12}, {0, 0, 0}, 20)},
          {"against", camera, spotAt({0, 0, -6}, {0, 1, 6}, 30)},
          {"at the camera", camera, spotAt({0, 1, 6}, {0, 0, 0}, 30)},
          {"behind the camera", camera, spotAt({0, 1, 9}, {0, 1, 20}, 30)},
          {"in the picture", camera, spotAt({0.3f, 0.2f, 0.1f}, {1, 0, 0}, 40)},
          {"in the picture, towards the camera", camera, spotAt({0, 0, 0}, {0, 1, 6}, 40)},
          {"wide", camera, spotAt({0, 3, 0}, {0, 0, 0}, 85)},
          {"all around, in the picture", camera, omniAt({0.1f, 0.2f, 0.3f})},
          {"all around, at the camera", camera, omniAt({0, 1, 6})},
          {"all around, aside", camera, omniAt({5, 3, 1})},
          {"sun across", camera, sunAlong({0, -1, 0})},
          {"sun along", cameraAt({0, 0, 6}, {0, 0, 0}), sunAlong({0, 0, -1})},
          {"sun against", cameraAt({0, 0, 6}, {0, 0, 0}), sunAlong({0, 0, 2})},
          {"sun aslant", camera, sunAlong({1, -2, 0.5f})}};
}

void expectInSquare(const VisibleSpace& visible, const LightFrame& frame, Random& random) {
  const ConvexBody body = bodyOf(visible, frame);
  const auto space = LightSpace::make(visible, frame, body);
  if (!space) return;
  ConvexBody lit = body;
  lit.clip(frustumOf(frame, 1e-3 * visible.scene.diagonal()));
  const auto expect = [&](const glm::dvec3& p) {
    const glm::dvec2 at = space->project(p);
    EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1.0 + 1e-6) << p.x << " " << p.y << " " << p.z;
    EXPECT_TRUE(std::isfinite(at.x) && std::isfinite(at.y));
    EXPECT_GE(space->eyeDepth(p), visible.nearDepth);
  };
  for (const glm::dvec3& p : lit.vertices()) expect(p);
  for (int i = 0; i < 200 && !lit.empty(); ++i) expect(randomIn(lit, random));
}

TEST(LightSpaces, HaveTheBodyInTheirSquare) {
  Random random(1);
  for (const Situation& situation : situations()) {
    SCOPED_TRACE(situation.name);
    for (const glm::vec3& half : {glm::vec3(2, 1, 2), glm::vec3(5, 0, 5), glm::vec3(0.1f, 30, 0.1f)}) {
      const VisibleSpace visible = visibleSpace(situation.camera, 1.5, 1e-3, boxOf(half));
      for (const LightFrame& frame : lightFrames(situation.light)) expectInSquare(visible, frame, random);
    }
  }
}

TEST(LightSpaces, HaveTheBodyInTheirSquareWhateverThePoses) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = cameraAt(float(random.uniform(0.1, 8)) * random.direction(), 2.0f * random.direction(),
                                   float(random.uniform(10, 120)));
    const VisibleSpace visible = visibleSpace(camera, random.uniform(0.5, 2), 1e-3, boxOf({2, 1, 3}));
    const Light spot = spotAt(float(random.uniform(0.1, 8)) * random.direction(), 2.0f * random.direction(),
                              float(random.uniform(5, 80)));
    for (const Light& light : {spot, omniAt(spot.position), sunAlong(random.direction())})
      for (const LightFrame& frame : lightFrames(light)) expectInSquare(visible, frame, random);
  }
}

/// What is in the body: casters between the light and anything that is seen.
TEST(LightSpaces, BodiesHoldWhatIsBetweenLightAndPicture) {
  Random random(3);
  int tried = 0;
  for (const Situation& situation : situations()) {
    const VisibleSpace visible = visibleSpace(situation.camera, 1.5, 1e-3, boxOf({2, 1, 2}));
    const std::vector<HalfSpace> seen = visible.frustum.halfSpaces();
    for (const LightFrame& frame : lightFrames(situation.light)) {
      const ConvexBody body = bodyOf(visible, frame);
      const std::vector<HalfSpace> sides = body.halfSpaces(), cone = frustumOf(frame, 0.0);
      for (int i = 0; i < 300; ++i) {
        const glm::dvec3 receiver(random.uniform(-2, 2), random.uniform(-1, 1), random.uniform(-2, 2));
        const auto inside = [&](const HalfSpace& side) { return side.distance(receiver) > 0.0; };
        if (!std::all_of(seen.begin(), seen.end(), inside) || !std::all_of(cone.begin(), cone.end(), inside)) continue;
        const glm::dvec3 way = frame.parallel ? -3.0 * frame.axis : frame.position - receiver;
        const glm::dvec3 caster = receiver + random.uniform(0.0, 1.0) * way;
        if (glm::any(glm::greaterThan(glm::abs(caster), glm::dvec3(2, 1, 2)))) continue;
        ++tried;
        for (const HalfSpace& side : sides)
          EXPECT_GE(side.distance(caster), -1e-9) << situation.name << ": " << side.distance(caster);
        EXPECT_FALSE(body.empty());
      }
    }
  }
  EXPECT_GT(tried, 500);
}

/// Light straight down, a level camera at height 0: z of the light space is the depth before the camera, n = zn +
/// sqrt(zf zn), and the square's y is -1 at zn, 1 at zf [Wimmer 2004].
TEST(LightSpaces, AreWimmersAtRightAngles) {
  const VisibleSpace visible = visibleSpace(cameraAt({0, 0, 6}, {0, 0, 0}), 1.0, 1e-3, boxOf({2, 1, 4}));
  const LightFrame frame = lightFrames(sunAlong({0, -1, 0})).front();
  const auto space = LightSpace::make(visible, frame, bodyOf(visible, frame));
  ASSERT_TRUE(space);
  const double zn = 2.0 - 1e-3, zf = 10.0 + 1e-3;  // with a little room around the box
  const double n = zn + std::sqrt(zf * zn), f = n + zf - zn;
  for (const double depth : {2.0, 2.5, 3.0, 5.0, 10.0}) {
    const double away = depth - zn + n;
    EXPECT_NEAR(space->project({0, 0.3, 6.0 - depth}).y, (f + n) / (f - n) - 2.0 * f * n / ((f - n) * away), 2e-3)
        << depth;
    EXPECT_NEAR(space->eyeDepth({0.1, -0.3, 6.0 - depth}), depth, 2e-3);
  }
}

TEST(LightSpaces, GrowAlongTheView) {
  Random random(4);
  for (const glm::vec3& direction : {glm::vec3(0, -1, 0), glm::vec3(1, -2, 0.5f), glm::vec3(0.3f, 1, 0.3f)}) {
    const VisibleSpace visible = visibleSpace(cameraAt({0, 1, 6}, {0, 0, 0}), 1.5, 1e-3, boxOf({2, 1, 2}));
    const LightFrame frame = lightFrames(sunAlong(direction)).front();
    const ConvexBody body = bodyOf(visible, frame);
    const auto space = LightSpace::make(visible, frame, body);
    ASSERT_TRUE(space);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 p = randomIn(body, random), q = p + 0.05 * visible.forward;
      EXPECT_GT(space->project(q).y, space->project(p).y);
      EXPECT_GE(space->eyeDepth(q), space->eyeDepth(p));
    }
  }
}

/// The perspective makes near things large.
TEST(LightSpaces, GiveNearObjectsMoreRoom) {
  const VisibleSpace visible = visibleSpace(cameraAt({0, 0, 6}, {0, 0, 0}), 1.0, 1e-3, boxOf({2, 1, 4}));
  for (const Light& light : {sunAlong({0, -1, 0}), spotAt({0, 12, 0}, {0, 0, 0}, 40)}) {
    const LightFrame frame = lightFrames(light).front();
    const auto space = LightSpace::make(visible, frame, bodyOf(visible, frame));
    ASSERT_TRUE(space);
    const auto width = [&](double z) {
      return glm::distance(space->project({-0.2, 0, z}), space->project({0.2, 0, z}));
    };
    EXPECT_GT(width(3.5), 1.3 * width(0.0));
    EXPECT_GT(width(0.0), 1.3 * width(-3.5));
  }
}

}  // namespace
}  // namespace cdsm::cluster
