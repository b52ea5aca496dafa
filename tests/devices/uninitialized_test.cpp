// SPDX-License-Identifier: Apache-2.0
// No result depends on what was in device memory before: the same bytes come out, whatever new buffers are filled with.
// (Oclgrind's --uninitialized cannot run our kernels: it stops at LLVM's `freeze`, and crashes without optimization.)
#include <gtest/gtest.h>

#include "poison.hpp"
#include "tiny_scenes.hpp"

namespace cdsm::devices {
namespace {

struct Case {
  const char* name;
  Scene scene;
};

Scene occluding(Scene scene) {
  scene.ambientOcclusion = AmbientOcclusion{8, 0.7f, 16, 1.0f};
  return scene;
}

std::vector<Case> cases() {
  const auto maps = [](const Scene& scene, const char* memory) {
    return along(scene, "deep-shadow-map", memory, "bilinear");
  };
  return {{"EverythingChunked", maps(everythingScene(), "chunked")},
          {"EverythingAtlas", maps(everythingScene(), "atlas")},
          {"EverythingExact", maps(everythingScene(), "exact")},
          {"EverythingTiled", maps(everythingScene(), "tiled")},
          {"EverythingRays", along(everythingScene(), "shadow-rays", "chunked", "bilinear")},
          {"EverythingDepths", along(everythingScene(), "shadow-map", "chunked", "bilinear")},
          {"EverythingPhotons", along(everythingScene(), "stochastic", "chunked", "bilinear")},
          {"SpheresThemselves", along(spheresScene(), "implicit-sphere", "chunked", "bilinear")},
          {"SpheresOccluding", occluding(along(spheresScene(), "none", "chunked", "bilinear"))},
          {"VolumeChunked", maps(volumeScene(VoxelType::UInt8), "chunked")},
          {"VolumeNone", along(volumeScene(VoxelType::UInt8), "none", "chunked", "bilinear")},
          {"CutAtlas", maps(cutScene(), "atlas")},
          {"StackChunked", maps(stackScene(), "chunked")},
          {"StackAtlas", maps(stackScene(), "atlas")},
          {"StackExact", maps(stackScene(), "exact")},
          {"StackTiled", maps(stackScene(), "tiled")},
          {"StackFixed", maps(stackScene(), "fixed")}};
}

class Uninitialized : public ::testing::TestWithParam<std::tuple<std::size_t, const char*>> {
 protected:
  void TearDown() override { poisonNewBuffers(std::nullopt); }

  std::string bytesWith(unsigned char poison) {
    poisonNewBuffers(poison);
    Engine engine = engineFor(std::get<1>(GetParam()));
    return expectSound(engine, cases()[std::get<0>(GetParam())].scene);
  }
};

TEST_P(Uninitialized, memoryReachesNoResult) {
  const std::string zeros = bytesWith(0x00);
  EXPECT_TRUE(bytesWith(0xff) == zeros) << "filled with NaN";
  EXPECT_TRUE(bytesWith(0x3f) == zeros) << "filled with 0.747";
}

const auto kName = [](const auto& instance) {
  return std::string(cases()[std::get<0>(instance.param)].name) + std::get<1>(instance.param);
};

INSTANTIATE_TEST_SUITE_P(Buffers, Uninitialized,
                         ::testing::Combine(::testing::Range<std::size_t>(0, cases().size()),
                                            ::testing::Values("buffer")),
                         kName);
INSTANTIATE_TEST_SUITE_P(Images, Uninitialized,
                         ::testing::Combine(::testing::Values<std::size_t>(0, 1, 2, 3), ::testing::Values("image")),
                         kName);

}  // namespace
}  // namespace cdsm::devices
