// SPDX-License-Identifier: Apache-2.0
// A frame of an animation is the still scene with its values, whatever one engine rendered before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <random>

#include "engine_paths.hpp"
#include "frames.hpp"
#include "io/points_file.hpp"
#include "io/scene_file.hpp"

namespace cdsm::property {
namespace {

constexpr int kFrames = 9;
constexpr std::uint32_t kSeed = 7u;

std::string fileOf(const std::string& name) {
  return (std::filesystem::path(CDSM_TEST_DATA) / "../../scenes/analytic" / name).string();
}

/// moving_light.toml at a frame, through slab.toml: six decimals write its values exactly.
Scene stillScene(int frame) {
  const std::string x = std::to_string(-2.0 + 0.5 * frame), z = std::to_string(std::abs(frame - 4) * 0.25);
  const double opacity = 0.25 + 0.125 * (std::clamp(frame, 2, 6) - 2);
  return io::readScene(fileOf("slab.toml"),
                       {"camera.fov=" + std::to_string(41 + frame), "light.key.position=[" + x + ", 4.0, " + z + "]",
                        "volume.slab.opacity=[[0.0, " + std::to_string(opacity) + "]]"});
}

TEST(Animation, IsTheStillSceneAtEachFrameInAnyOrder) {
  io::SceneReader reader(fileOf("moving_light.toml"));
  Engine& engine = engineOf("buffer");
  std::vector<Image> images;
  for (int frame = 0; frame < kFrames; ++frame) images.push_back(engine.render(reader.frame(frame)));
  EXPECT_FALSE(sameBytes(images[0], images[1]));
  std::vector<int> order;
  for (int frame = 0; frame < kFrames; ++frame) order.push_back(frame);
  std::shuffle(order.begin(), order.end(), std::mt19937(kSeed));
  for (const int frame : order) {
    EXPECT_TRUE(sameBytes(engine.render(reader.frame(frame)), images[frame])) << "frame " << frame;
    EXPECT_TRUE(sameBytes(engine.render(stillScene(frame)), images[frame])) << "frame " << frame << " as a still";
  }
}

TEST(Animation, AnswersAsTheSceneOfItsFrame) {
  io::SceneReader reader(fileOf("moving_light.toml"));
  const std::vector<glm::vec3> points = io::readPoints(fileOf("points.csv"));
  const auto still = query(mapPath(), io::readScene(fileOf("slab.toml")), points);
  EXPECT_GT(largestDifference(query(mapPath(), reader.frame(0), points), still), 0.01);
  EXPECT_EQ(largestDifference(query(mapPath(), reader.frame(4), points), still), 0.0);
}

/// Voxels spoilt after the first frame show that they were neither looked at nor uploaded again.
TEST(Animation, LooksAtDataOnce) {
  Scene scene = io::readScene(fileOf("slab.toml"));
  VolumeData grid;
  grid.type = VoxelType::Float32;
  grid.size = {2, 2, 2};
  grid.voxels.resize(32);
  const auto voxels = std::make_shared<VolumeData>(grid);
  scene.volumes.at(0).data = voxels;
  Engine& engine = engineOf("buffer");
  const Image first = engine.render(scene);
  std::memset(voxels->voxels.data(), 0xff, voxels->voxels.size());  // NaN
  scene.volumes.at(0).worldFromObject[3].x = 1.0f;
  EXPECT_FALSE(sameBytes(engine.render(scene), first));
  scene.volumes.at(0).worldFromObject[3].x = 0.0f;
  EXPECT_TRUE(sameBytes(engine.render(scene), first));
}

}  // namespace
}  // namespace cdsm::property
