// SPDX-License-Identifier: Apache-2.0
// The whole engine on scenes small enough for an interpreter of kernels (oclgrind): every technique, memory strategy
// and fetch, images and queries. What counts is what the interpreter sees on the way.
#include <gtest/gtest.h>

#include "tiny_scenes.hpp"

namespace cdsm::devices {
namespace {

class TinyEngine : public ::testing::TestWithParam<const char*> {
 protected:
  Engine engine_{EngineOptions{"", GetParam(), {}}};
};

TEST_P(TinyEngine, everythingByMaps) {
  expectSound(engine_, along(everythingScene(), "deep-shadow-map", "chunked", "bilinear"));
}
TEST_P(TinyEngine, everythingByRays) {
  expectSound(engine_, along(everythingScene(), "shadow-rays", "chunked", "bilinear"));
}
TEST_P(TinyEngine, everythingByDepths) {
  expectSound(engine_, along(everythingScene(), "shadow-map", "chunked", "bilinear"));
}
TEST_P(TinyEngine, everythingByPhotons) {
  for (const char* filter : {"bilinear", "nearest"})
    expectSound(engine_, along(everythingScene(), "stochastic", "chunked", filter));
}
TEST_P(TinyEngine, volumesByOpaqueRays) {
  Scene scene = along(cutScene(), "shadow-rays", "chunked", "bilinear");
  scene.shadows.rays = "opaque";
  expectSound(engine_, scene);
}
TEST_P(TinyEngine, volumesInAnAtlas) {
  expectSound(engine_, along(volumeScene(VoxelType::Int16), "deep-shadow-map", "atlas", "bilinear"));
}
TEST_P(TinyEngine, volumesInExactMaps) {
  expectSound(engine_, along(volumeScene(VoxelType::UInt8), "deep-shadow-map", "exact", "bilinear"));
}
TEST_P(TinyEngine, volumesInTiledMaps) {
  expectSound(engine_, along(volumeScene(VoxelType::UInt8), "deep-shadow-map", "tiled", "bilinear"));
}
TEST_P(TinyEngine, volumesWithoutShadows) {
  expectSound(engine_, along(volumeScene(VoxelType::UInt8), "none", "chunked", "bilinear"));
}
TEST_P(TinyEngine, cutVolumesFromInside) {
  expectSound(engine_, along(cutScene(), "deep-shadow-map", "chunked", "nearest"));
  expectSound(engine_, along(cutScene(), "shadow-rays", "chunked", "nearest"));
}
TEST_P(TinyEngine, roomThatGrows) {
  expectSound(engine_, along(stackScene(), "deep-shadow-map", "atlas", "nearest"));
  expectSound(engine_, along(stackScene(), "deep-shadow-map", "chunked", "nearest"));
  expectSound(engine_, along(stackScene(), "deep-shadow-map", "exact", "nearest"));
  expectSound(engine_, along(stackScene(), "deep-shadow-map", "tiled", "nearest"));
}
TEST_P(TinyEngine, nodesOf16Bits) {
  for (const char* memory : {"atlas", "chunked", "exact", "tiled", "fixed"}) {
    Scene scene = along(stackScene(), "deep-shadow-map", memory, "nearest");
    scene.shadows.nodeFormat = "unorm16";
    scene.shadows.tolerance = 0.001f;
    expectSound(engine_, scene);
  }
  Scene scene = along(everythingScene(), "deep-shadow-map", "exact", "bilinear");
  scene.shadows.nodeFormat = "unorm16";
  scene.shadows.tolerance = 0.001f;
  expectSound(engine_, scene);
}
TEST_P(TinyEngine, nodesThatAreMerged) {
  expectSound(engine_, along(stackScene(), "deep-shadow-map", "fixed", "nearest"));
}
TEST_P(TinyEngine, everythingByCachedMaps) {
  Scene scene = along(everythingScene(), "deep-shadow-map", "exact", "bilinear");
  scene.shadows.cache = "volume";
  expectSound(engine_, scene);
}
TEST_P(TinyEngine, spheresByThemselves) {
  Scene scene = along(spheresScene(), "implicit-sphere", "exact", "bilinear");
  expectSound(engine_, scene);
  scene.shadows.patch = ShadowSettings::kPatchAuto;
  scene.shadows.softness = 0.2f;
  expectSound(engine_, scene);
}
TEST_P(TinyEngine, spheresThatOcclude) {
  Scene scene = along(spheresScene(), "none", "exact", "bilinear");
  scene.ambientOcclusion = AmbientOcclusion{4, 0.7f, 8, 1.0f};
  expectSound(engine_, scene);
}
TEST_P(TinyEngine, debugPictures) {
  const Scene scene = along(everythingScene(), "deep-shadow-map", "chunked", "bilinear");
  for (const DebugView view : {DebugView::Clusters, DebugView::Nodes, DebugView::Steps, DebugView::Texels})
    EXPECT_FALSE(engine_.render(scene, {view, {}}).pixels.empty());
}

INSTANTIATE_TEST_SUITE_P(Fetch, TinyEngine, ::testing::Values("buffer", "image"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace cdsm::devices
