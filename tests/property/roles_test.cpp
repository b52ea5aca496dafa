// SPDX-License-Identifier: Apache-2.0
// Objects that cast no shadow or are not shadowed: transmittances by hand, pictures without a shadow, pictures after a
// change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine_paths.hpp"
#include "frames.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 64;
constexpr float kTolerance = 0.002f;
/// Single precision, and what a map may be off.
constexpr double kAllowed = 3e-4 + 2.0 * static_cast<double>(kTolerance);

constexpr float kOpacity = 0.25f;    ///< of one crossing of the box's surface
constexpr float kExtinction = 0.5f;  ///< of what fills the box
constexpr double kSigma = 0.693147;  ///< of the volume: opacity 0.5 per unit

const std::vector<Path> kPaths{rayPath(), mapPath("chunked"), mapPath("atlas"), mapPath("exact"), mapPath("tiled")};

/// A filled, translucent box, 1 high around the origin, that cuts a volume twice as high.
Scene cutScene(bool meshCasts, bool volumeCasts) {
  Scene scene = reference::emptyScene();
  const int box = reference::addMesh(scene, reference::boxMesh({-1.5f, -0.5f, -1.5f}, {1.5f, 0.5f, 1.5f}),
                                     reference::addMaterial(scene, glm::vec3(0.8f), kOpacity));
  scene.meshes.front().interiorExtinction = kExtinction;
  scene.meshes.front().shadow.casts = meshCasts;
  reference::addVolume(scene,
                       reference::makeVolume(VoxelType::UInt8, glm::uvec3(16), {-2, -1, -2}, {2, 1, 2},
                                             [](const glm::dvec3&) { return 1.0; }),
                       reference::constantOpacity(0.5f, 1.0f));
  scene.volumes.front().boundary = box;
  scene.volumes.front().shadow.casts = volumeCasts;
  return scene;
}

/// Through `height` of the box and `crossings` of its surface.
double byHand(const Scene& scene, const glm::dvec3& way, double height, int crossings) {
  const double length = height * glm::length(way) / std::abs(way.y);
  double transmittance = 1.0;
  if (scene.meshes.front().shadow.casts)
    transmittance *= std::pow(1.0 - double(kOpacity), crossings) * std::exp(-double(kExtinction) * length);
  if (scene.volumes.front().shadow.casts) transmittance *= std::exp(-kSigma * length);
  return transmittance;
}

void expectByHand(Scene scene) {
  const glm::vec3 below(0.13f, -2.0f, 0.07f), inside(0.13f, -0.2f, 0.07f), abovePosition(0.0f, 4.0f, 0.0f);
  const glm::vec3 insidePosition(0.02f, 0.1f, 0.01f);
  for (const Path& path : kPaths) {
    scene.lights.front().position = abovePosition;
    const auto above = query(path, along(path, scene, kMapSize, kTolerance), {below, inside});
    EXPECT_NEAR(above[0].transmittance, byHand(scene, below - abovePosition, 1.0, 2), kAllowed) << path.name();
    EXPECT_NEAR(above[1].transmittance, byHand(scene, inside - abovePosition, 0.7, 1), kAllowed) << path.name();
    scene.lights.front().position = insidePosition;
    scene.lights.front().target = below;
    const auto within = query(path, along(path, scene, kMapSize, kTolerance), {below});
    EXPECT_NEAR(within[0].transmittance, byHand(scene, below - insidePosition, 0.6, 1), kAllowed) << path.name();
    scene.lights.front().target = glm::vec3(0.0f);
  }
}

TEST(Roles, whatCastsNoShadowStillCuts) {
  for (const bool mesh : {false, true}) {
    for (const bool volume : {false, true}) {
      SCOPED_TRACE("mesh casts: " + std::to_string(mesh) + ", volume casts: " + std::to_string(volume));
      expectByHand(cutScene(mesh, volume));
    }
  }
}

/// All roles of the scene's objects.
std::vector<ShadowRole*> rolesOf(Scene& scene) {
  std::vector<ShadowRole*> roles;
  for (Mesh& mesh : scene.meshes) roles.push_back(&mesh.shadow);
  for (Volume& volume : scene.volumes) roles.push_back(&volume.shadow);
  return roles;
}

Image render(const Path& path, const Scene& scene) {
  return engineOf(path.fetch).render(along(path, scene, kMapSize, kTolerance));
}

TEST(Roles, withoutReceiversOrCastersThereIsNoShadow) {
  Scene lit = reference::randomScene(5);
  const std::vector<Light> others = reference::otherLights(5);
  lit.lights.insert(lit.lights.end(), others.begin(), others.end());
  const Image expected = render({"none", "chunked", "bilinear", "buffer"}, lit);
  Scene noReceivers = lit, noCasters = lit;
  for (ShadowRole* role : rolesOf(noReceivers)) role->receives = false;
  for (ShadowRole* role : rolesOf(noCasters)) role->casts = false;
  for (const Path& path : kPaths) {
    EXPECT_GT(largestStep(render(path, lit), expected), 0.05f) << path.name();
    EXPECT_LE(largestStep(render(path, noReceivers), expected), 1e-5f) << path.name();
    EXPECT_LE(largestStep(render(path, noCasters), expected), 1e-5f) << path.name();
  }
}

TEST(Roles, ofReceiversDoNotConcernQueries) {
  const std::vector<glm::vec3> points{{0.1f, 0.2f, 0.0f}, {0.0f, -2.0f, 0.1f}, {0.3f, -0.4f, 0.2f}};
  Scene scene = reference::randomScene(5);
  Scene noReceivers = scene;
  for (ShadowRole* role : rolesOf(noReceivers)) role->receives = false;
  for (const Path& path : kPaths) {
    EXPECT_EQ(largestDifference(query(path, along(path, scene, kMapSize, kTolerance), points),
                                query(path, along(path, noReceivers, kMapSize, kTolerance), points)),
              0.0)
        << path.name();
  }
}

/// One engine, one object after another: the picture changes with the role and changes back.
TEST(Roles, mayChangeFromFrameToFrame) {
  const Scene scene = cutScene(true, true);
  for (const Path& path : kPaths) {
    const Image before = render(path, scene);
    for (std::size_t i = 0; i < 2; ++i) {
      Scene changed = scene;
      rolesOf(changed)[i]->receives = false;
      EXPECT_GT(largestStep(render(path, changed), before), 0.02f) << path.name() << ", object " << i;
      EXPECT_EQ(largestStep(render(path, scene), before), 0.0f) << path.name() << ", object " << i;
      changed = scene;
      rolesOf(changed)[i]->casts = false;
      EXPECT_GT(largestStep(render(path, changed), before), 0.02f) << path.name() << ", object " << i;
      EXPECT_EQ(largestStep(render(path, scene), before), 0.0f) << path.name() << ", object " << i;
    }
  }
}

}  // namespace
}  // namespace cdsm::property
