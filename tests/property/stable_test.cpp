// SPDX-License-Identifier: Apache-2.0
// Shadows along a camera path on which clusters change: with `stable` they do not jump, are as right as without, and
// the maps stay once the camera does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "cluster/hand_over.hpp"
#include "engine_paths.hpp"
#include "frames.hpp"

namespace cdsm::property {
namespace {

constexpr int kFrames = 60;
constexpr int kMapSize = 32;  ///< few texels: other clusters have other shadows
constexpr float kTolerance = 0.01f;

Scene atFrame(int frame, bool stable) {
  static const Scene row = rowScene();  // the same meshes in all frames
  Scene scene = along(mapPath("chunked", "bilinear", 2), row, kMapSize, kTolerance);
  scene.meshes.back().shadow.casts = false;  // the floor, which would need a cluster of its own
  const float angle = 0.06f * float(frame);
  scene.camera.position = {2.2f * std::sin(angle), 1.0f, 2.2f * std::cos(angle)};
  scene.shadows.stable = stable;
  return scene;
}

/// On the floor.
std::vector<glm::vec3> floorPoints() {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 900; ++i) points.emplace_back(0.1f * float(i % 30) - 1.5f, -0.59f, 0.1f * float(i / 30) - 1.5f);
  return points;
}

struct Flight {
  double largestStep = 0.0;   ///< of the transmittance at any point, from frame to frame
  double largestError = 0.0;  ///< root of the mean square over the points
  int changes = 0;            ///< frames that built maps
  int fading = 0;             ///< frames with more maps than clusters
};

double rmsError(const std::vector<Transmittance>& a, const std::vector<Transmittance>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(double(a[i].transmittance) - b[i].transmittance, 2.0);
  return std::sqrt(sum / double(a.size()));
}

bool builtAny(const FrameStats& stats) {
  const std::vector<MapStats>& maps = stats.lights[0].maps;
  return std::any_of(maps.begin(), maps.end(), [](const MapStats& map) { return map.regenerated; });
}

Flight fly(Engine& engine, bool stable) {
  const std::vector<glm::vec3> points = floorPoints();
  const auto exact = query(rayPath(), along(rayPath(), atFrame(0, false), kMapSize, kTolerance), points);
  Flight flight;
  std::vector<Transmittance> before;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Scene scene = atFrame(frame, stable);
    engine.render(scene);
    flight.changes += builtAny(engine.stats());
    flight.fading += engine.stats().lights[0].maps.size() > 2;
    for (const MapStats& map : engine.stats().lights[0].maps)
      if (frame > 0) EXPECT_TRUE(map.reason.empty() || map.reason == "cluster") << map.reason;
    auto now = engine.transmittance(scene, "key", points);
    if (stable) EXPECT_FALSE(builtAny(engine.stats())) << "queries see what the picture sees";
    flight.largestError = std::max(flight.largestError, rmsError(now, exact));
    if (frame > 0) flight.largestStep = std::max(flight.largestStep, largestDifference(now, before));
    before = std::move(now);
  }
  return flight;
}

TEST(Stable, ShadowsDoNotJumpWhenClustersChange) {
  Engine jumping, smooth;
  const Flight without = fly(jumping, false), with = fly(smooth, true);
  std::cout << "steps " << without.largestStep << " and " << with.largestStep << ", errors " << without.largestError
            << " and " << with.largestError << ", changes " << without.changes << " and " << with.changes << ", fading "
            << with.fading << "\n";
  EXPECT_GT(without.changes, 2);
  EXPECT_GT(with.changes, 1);
  EXPECT_GE(with.fading, cluster::HandOver::kFrames - 1);
  EXPECT_LE(with.largestStep, 0.3 * without.largestStep);
  EXPECT_LE(with.largestError, 1.15 * without.largestError);
}

TEST(Stable, MapsStayOnceTheCameraDoes) {
  Engine engine;
  for (int frame = 0; frame < kFrames; ++frame) engine.render(atFrame(frame, true));
  const Scene last = atFrame(kFrames - 1, true);
  for (int frame = 0; frame < 2 * cluster::HandOver::kFrames; ++frame) engine.render(last);
  const Image settled = engine.render(last);
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(sameBytes(engine.render(last), settled));
    EXPECT_FALSE(builtAny(engine.stats()));
    EXPECT_LE(engine.stats().lights[0].maps.size(), 2u);
  }
}

/// The picture of a first frame does not depend on `stable` but for what pictures may leave out.
/// Queries do not count as frames, but clusters of objects that are gone serve none.
TEST(Stable, QueriesSeeTheObjectsThatThereAre) {
  Engine engine{EngineOptions{}};
  Scene scene = atFrame(0, true);
  engine.render(scene);
  for (const bool fewer : {true, false}) {
    if (fewer)
      scene.meshes.erase(scene.meshes.begin(), scene.meshes.begin() + 2);
    else
      scene.meshes.insert(scene.meshes.end(), {rowScene().meshes[0], rowScene().meshes[1]});
    Scene fresh = scene;
    fresh.shadows.stable = false;
    const auto kept = engine.transmittance(scene, "key", floorPoints());
    EXPECT_LE(rmsError(kept, Engine(EngineOptions{}).transmittance(fresh, "key", floorPoints())), 0.05) << fewer;
  }
}

TEST(Stable, FirstFramesAreAsWithoutIt) {
  const std::vector<glm::vec3> points = floorPoints();
  Engine one, other;
  EXPECT_EQ(largestDifference(one.transmittance(atFrame(5, true), "key", points),
                              other.transmittance(atFrame(5, false), "key", points)),
            0.0);
}

}  // namespace
}  // namespace cdsm::property
