// SPDX-License-Identifier: Apache-2.0
// A device of 1 GiB, 256 MiB at once (POCL_MEMORY_LIMIT=1): what fits works, what does not is refused with the bytes
// that it needs, and the engine goes on as if nothing had been asked.
#include <gtest/gtest.h>

#include <regex>

#include "reference/test_scenes.hpp"
#include "tiny_scenes.hpp"

namespace cdsm::devices {
namespace {

class SmallDevice : public ::testing::Test {
 protected:
  Engine engine_;
  Scene scene_ = volumeScene(VoxelType::UInt8);

  void SetUp() override {
    if (engine_.device().memoryBytes > std::uint64_t(2) << 30)
      GTEST_SKIP() << "the device is not small; POCL_MEMORY_LIMIT=1 makes PoCL's so";
  }

  /// Refused with a number of bytes; before and after it, the small scene gives the same.
  void expectRefused(const Scene& large) {
    const std::string before = expectSound(engine_, scene_);
    try {
      engine_.render(large);
      ADD_FAILURE() << "was not refused";
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_TRUE(std::regex_search(message, std::regex("[0-9]{7,}"))) << "no number of bytes: " << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
    EXPECT_TRUE(expectSound(engine_, scene_) == before) << "the small scene looks different now";
  }
};

TEST_F(SmallDevice, smallScenesWork) {
  expectSound(engine_, scene_);
  expectSound(engine_, everythingScene());
  expectSound(engine_, along(stackScene(), "deep-shadow-map", "atlas", "nearest"));
}

TEST_F(SmallDevice, mapsThatFitAreBuilt) {
  for (const char* memory : {"chunked", "atlas", "exact", "tiled", "fixed"}) {
    Scene scene = along(scene_, "deep-shadow-map", memory, "bilinear");
    scene.shadows.mapSize = 512;
    expectSound(engine_, scene);
  }
}

TEST_F(SmallDevice, refusesAnAtlasThatDoesNotFit) {
  Scene scene = along(scene_, "deep-shadow-map", "atlas", "bilinear");
  scene.shadows.mapSize = 16384;
  expectRefused(scene);
}

TEST_F(SmallDevice, refusesChunksThatDoNotFit) {
  Scene scene = along(scene_, "deep-shadow-map", "chunked", "bilinear");
  scene.shadows.mapSize = 16384;
  expectRefused(scene);
}

TEST_F(SmallDevice, refusesExactMapsThatDoNotFit) {
  for (const char* memory : {"exact", "tiled", "fixed"}) {
    Scene scene = along(scene_, "deep-shadow-map", memory, "bilinear");
    scene.shadows.mapSize = 16384;
    expectRefused(scene);
  }
}

TEST_F(SmallDevice, refusesAnImageThatDoesNotFit) {
  Scene scene = scene_;
  scene.image.width = scene.image.height = 16384;
  expectRefused(scene);
}

TEST_F(SmallDevice, refusesAnImageOfTooManyRays) {
  Scene scene = scene_;
  scene.image.width = scene.image.height = 2048;
  scene.image.supersampling = 8;
  expectRefused(scene);
}

TEST_F(SmallDevice, refusesAVolumeThatDoesNotFit) {
  VolumeData data;
  data.type = VoxelType::UInt8;
  data.size = glm::uvec3(700, 700, 600);
  data.voxels.resize(std::size_t(700) * 700 * 600);
  Scene scene = reference::emptyScene();
  reference::addVolume(scene, std::move(data), reference::linearOpacity(255.0, 0.5f, 1.0f));
  expectRefused(scene);
}

/// Two hundred sheets over a map of a million texels: the layers themselves do not fit.
TEST_F(SmallDevice, refusesLayersThatDoNotFit) {
  Scene scene = reference::emptyScene();
  reference::addMesh(scene, reference::stackMesh(200, 1.0f, 0.01f, 3.0f),
                     reference::addMaterial(scene, glm::vec3(0.7f), 0.01f));
  scene.shadows.mapSize = 1024;
  expectRefused(scene);
}

}  // namespace
}  // namespace cdsm::devices
