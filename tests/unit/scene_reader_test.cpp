// SPDX-License-Identifier: Apache-2.0
// Animated scene files: what a frame is read as, and where and how wrong [[animate]] tables are refused.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/scene_file.hpp"
#include "io_test_files.hpp"

namespace cdsm::io {
namespace {

using test::expectError;
using test::TemporaryFolder;

const std::string kScene = R"([camera]
fov = 45
[image]
width = 64
[[light]]
name = "key"
[[light]]
name = "fill.two"
[[light]]
name = "sun"
type = "directional"
[[material]]
name = "m"
[[mesh]]
name = "cup"
file = "closed.obj"
material = "m"
[[volume]]
name = "smoke"
file = "grid.nrrd"
opacity = [[0, 0.5], [9, 0.25]]
color = [[0, 1, 1, 1]]
)";
constexpr int kFirstLine = 23;  ///< of what a test appends

class AnimatedScene : public ::testing::Test {
 protected:
  AnimatedScene() {
    folder_.write("closed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    folder_.write("grid.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678");
  }

  SceneReader reader(const std::string& tables, const std::vector<std::string>& overrides = {}) {
    return SceneReader(folder_.write("scene.toml", kScene + tables), overrides);
  }

  TemporaryFolder folder_;
};

std::string animate(const std::string& key, const std::string& frames) {
  return "[[animate]]\nkey = '" + key + "'\nframes = " + frames + "\n";
}

TEST_F(AnimatedScene, GivesScalarsVectorsAndDefaultsTheirValues) {
  SceneReader scenes = reader(
      animate("camera.fov", "[[0, 40], [10, 50.0]]") + animate("light.key.position", "[[4, 0, 4, 1], [6, 2, 8, 1]]") +
      animate("light.fill.two.color", "[[0, 1, 0, 0]]") + animate("shadows.step", "[[0, 0.5]]"));
  EXPECT_TRUE(scenes.animated());
  const Scene scene = scenes.frame(5);
  EXPECT_EQ(scene.camera.fov, 45.0f);
  EXPECT_EQ(scene.lights.at(0).position, glm::vec3(1, 6, 1));
  EXPECT_EQ(scene.lights.at(1).color, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene.shadows.step, 0.5f);
  EXPECT_EQ(scenes.frame(1).camera.fov, 41.0f);
}

TEST_F(AnimatedScene, RoundsIntegers) {
  SceneReader scenes = reader(animate("image.width", "[[0, 8], [4, 10]]") + animate("shadows.map_size", "[[0, 16.4]]"));
  const std::vector<int> widths{8, 9, 9, 10, 10};
  for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(scenes.frame(frame).image.width, widths[frame]) << frame;
  EXPECT_EQ(scenes.frame(0).shadows.mapSize, 16);
}

TEST_F(AnimatedScene, MovesObjects) {
  SceneReader scenes = reader(animate("mesh.cup.rotation", "[[0, 0, 0, 1, 0], [2, 0, 0, 1, 180]]") +
                              animate("mesh.cup.scale", "[[0, 1], [2, 3]]") +
                              animate("mesh.cup.position", "[[0, 0, 0, 0], [2, 2, 0, 0]]"));
  const glm::vec4 moved =
      scenes.frame(1).meshes.at(0).worldFromObject * glm::vec4(1, 0, 0, 1);  // (0, 2, 0) + (1, 0, 0)
  EXPECT_NEAR(moved.x, 1.0f, 1e-6f);
  EXPECT_NEAR(moved.y, 2.0f, 1e-6f);
  SceneReader stretched = reader(animate("volume.smoke.scale", "[[0, 1, 2, 3]]") +
                                 animate("mesh.cup.matrix", "[[0, 1,0,0,7, 0,1,0,8, 0,0,1,9, 0,0,0,1]]"));
  EXPECT_EQ(stretched.frame(0).volumes.at(0).worldFromObject[2][2], 3.0f);
  EXPECT_EQ(stretched.frame(0).meshes.at(0).worldFromObject[3], glm::vec4(7, 8, 9, 1));
}

TEST_F(AnimatedScene, ChangesTransferFunctions) {
  SceneReader scenes = reader(animate("volume.smoke.opacity", "[[0, 0, 0.5, 9, 0.25], [2, 0, 1.0, 19, 0.75]]") +
                              animate("volume.smoke.color", "[[0, 5, 1, 0.5, 0.25]]"));
  const TransferFunction transfer = scenes.frame(1).volumes.at(0).transfer;
  ASSERT_EQ(transfer.opacity.size(), 2u);
  EXPECT_EQ(transfer.opacity[0].opacity, 0.75f);
  EXPECT_EQ(transfer.opacity[1].value, 14.0f);
  EXPECT_EQ(transfer.opacity[1].opacity, 0.5f);
  ASSERT_EQ(transfer.color.size(), 1u);
  EXPECT_EQ(transfer.color[0].value, 5.0f);
  EXPECT_EQ(transfer.color[0].color, glm::vec3(1, 0.5, 0.25));
}

TEST_F(AnimatedScene, IsAStillWithTheSameValuesInAnyOrderOfFrames) {
  SceneReader scenes = reader(animate("camera.fov", "[[0, 10], [30, 11]]"));
  const auto still = [&](const std::string& fov) { return reader("", {"camera.fov=" + fov}).frame(0).camera.fov; };
  EXPECT_EQ(scenes.frame(7).camera.fov, still("10.233333333333333"));
  EXPECT_EQ(scenes.frame(29).camera.fov, still("10.966666666666667"));
  EXPECT_EQ(scenes.frame(7).camera.fov, still("10.233333333333333")) << "after a later one";
  EXPECT_EQ(readScene(folder_.write("first.toml", kScene + animate("camera.fov", "[[0, 10], [30, 11]]"))).camera.fov,
            10)
      << "without a number it is frame 0";
}

TEST_F(AnimatedScene, KeepsItsDataAndReadsNoFileAgain) {
  SceneReader scenes = reader(animate("mesh.cup.position", "[[0, 0, 0, 0], [9, 9, 0, 0]]"));
  const Scene first = scenes.frame(0);
  folder_.write("closed.obj", "no mesh");
  folder_.write("grid.nrrd", "no volume");
  const Scene second = scenes.frame(1);
  EXPECT_EQ(first.meshes.at(0).data, second.meshes.at(0).data);
  EXPECT_EQ(first.volumes.at(0).data, second.volumes.at(0).data);
}

TEST_F(AnimatedScene, IsChangedByOverridesOfOtherKeys) {
  const std::string table = animate("light.key.position", "[[0, 1, 2, 3]]");
  EXPECT_EQ(reader(table, {"light.key.cutoff=20"}).frame(3).lights.at(0).cutoff, 20.0f);
  EXPECT_FALSE(reader("").animated());
  expectError(
      [&] {
        reader(table, {"camera.fov=30", "light.key.position=[3, 3, 3]"});
      },
      "the key is animated in line 24 of the scene file, must be changed there");
  expectError([&] { reader(table, {"animate.light.key=3"}); }, "must be changed in the scene file");
}

struct Wrong {
  std::string key;
  std::string frames;
  std::string part;
  int line = kFirstLine + 1;  ///< of the key
  int column = 7;
};

TEST_F(AnimatedScene, RefusesWrongKeysAtTheirPlace) {
  const std::vector<Wrong> cases{
      {"fov", "[[0, 1]]", "'fov' is no dotted key, must be such as camera.fov"},
      {"camera.fof", "[[0, 1]]", "unknown key 'fof' of camera, did you mean 'fov'?"},
      {"light.key.x", "[[0, 1]]",
       "unknown key 'x' of light, must be one of: position, target, direction, cutoff, color"},
      {"camara.fov", "[[0, 1]]", "unknown table 'camara', did you mean 'camera'?"},
      {"camera.left.fov", "[[0, 1]]", "must have the form camera.KEY"},
      {"light.cutoff", "[[0, 1]]", "must have the form light.NAME.KEY"},
      {"light.kee.cutoff", "[[0, 1]]", "unknown light 'kee', must be one of: key, fill.two, sun"},
      {"ambient_occlusion.left.distance", "[[0, 1]]", "must have the form ambient_occlusion.KEY"},
      {"animate.a.frames", "[[0, 1]]", "'animate' has no dotted keys"},
      {"shadows.technique", "[[0, 1]]", "'technique' is a text, must be a key with numbers"},
      {"volume.smoke.file", "[[0, 1]]", "'file' is a text"},
      {"volume.smoke.shading", "[[0, 1]]", "'shading' is true or false, must be a key with numbers"},
  };
  for (const Wrong& wrong : cases) {
    expectError([&] { reader(animate(wrong.key, wrong.frames)); }, wrong.part, wrong.line, wrong.column);
  }
}

TEST_F(AnimatedScene, RefusesWrongFramesAtTheirPlace) {
  const int line = kFirstLine + 2;
  const std::vector<Wrong> cases{
      {"camera.fov", "[]", "frames must be an array of at least one row", line, 10},
      {"camera.fov", "3", "frames must be an array", line, 10},
      {"camera.fov", "[3]", "a row of frames is no array, must be [frame, 1 number]", line, 11},
      {"camera.fov", "[[]]", "a row of frames has 0 entries", line, 11},
      {"camera.fov", "[[0, 1, 2]]", "a row of frames has 3 entries, must be [frame, 1 number]", line, 11},
      {"camera.fov", "[[0, 1], [1]]", "a row of frames has 1 entries", line, 19},
      {"camera.fov", "[[0.5, 1]]", "does not begin with a frame, must be an integer in [0, 999999]", line, 12},
      {"camera.fov", "[[-1, 1]]", "does not begin with a frame", line, 12},
      {"camera.fov", "[[1000000, 1]]", "does not begin with a frame", line, 12},
      {"camera.fov", "[[0, '1']]", "an animated value is none, must be a finite number", line, 15},
      {"camera.fov", "[[0, nan]]", "must be a finite number", line, 15},
      {"camera.fov", "[[0, 1], [5, inf]]", "must be a finite number", line, 23},
      {"camera.fov", "[[3, 1], [3, 1]]", "frame 3 follows frame 3, frames must ascend", line, 19},
      {"camera.fov", "[[3, 1], [2, 1]]", "frame 2 follows frame 3", line, 19},
      {"light.key.position", "[[0, 1]]", "must be [frame, 3 numbers]", line, 11},
      {"light.key.position", "[[0, [1, 2, 3]]]", "must be [frame, 3 numbers]", line, 11},
      {"mesh.cup.rotation", "[[0, 1, 2, 3]]", "must be [frame, 4 numbers]", line, 11},
      {"mesh.cup.matrix", "[[0, 1, 2, 3]]", "must be [frame, 16 numbers]", line, 11},
      {"mesh.cup.scale", "[[0, 1, 2]]", "must be [frame, 1 or 3 numbers], alike in all rows", line, 11},
      {"mesh.cup.scale", "[[0, 1], [1, 1, 2, 3]]", "[frame, 1 or 3 numbers], alike in all rows", line, 19},
      {"volume.smoke.opacity", "[[0, 0, 0.5]]", "4 numbers]: 2 for each point, as many points as the scene's", line,
       11},
      {"volume.smoke.color", "[[0, 0, 1, 1]]", "4 numbers]: 4 for each point", line, 11},
  };
  for (const Wrong& wrong : cases) {
    expectError([&] { reader(animate(wrong.key, wrong.frames)); }, wrong.part, wrong.line, wrong.column);
  }
}

TEST_F(AnimatedScene, RefusesWrongTables) {
  expectError([&] { reader("[[animate]]\nkey = 'camera.fov'\n"); }, "[[animate]] has no 'frames'", kFirstLine, 1);
  expectError([&] { reader("[[animate]]\nframes = [[0, 1]]\n"); }, "[[animate]] has no 'key'", kFirstLine, 1);
  expectError([&] { reader("[[animate]]\nkey = 3\n"); }, "key is an integer, must be a string", kFirstLine + 1, 7);
  expectError([&] { reader("[[animate]]\nkeys = 3\n"); }, "unknown key 'keys' in [[animate]]", kFirstLine + 1, 1);
  expectError([&] { reader("[animate]\n"); }, "must be tables [[animate]]", kFirstLine, 1);
  const std::string fov = animate("camera.fov", "[[0, 1]]");
  expectError([&] { reader(fov + fov); }, "'camera.fov' is already animated in line 24", kFirstLine + 4, 7);
}

TEST_F(AnimatedScene, NamesTheFrameAtWhichAValueGoesWrong) {
  const auto expectWrong = [&](const std::string& key, const std::string& frames, int good, int bad,
                               const std::string& part) {
    SceneReader scenes = reader(animate(key, frames));
    EXPECT_NO_THROW(scenes.frame(good)) << key;
    expectError([&] { scenes.frame(bad); }, "frame " + std::to_string(bad) + ": " + part, kFirstLine + 1, 7);
    EXPECT_NO_THROW(scenes.frame(good)) << key;
  };
  expectWrong("camera.fov", "[[0, 150], [10, 200]]", 5, 6, "fov is 180, must be in (0, 180) degrees");
  expectWrong("image.width", "[[0, 9], [9, 1e30]]", 0, 9, "width is 9.007199e+15, must be in [1, 16384]");
  expectWrong("light.key.position", "[[0, 2, 2, 2], [2, -2, -2, -2]]", 0, 1, "light 'key': position and target");
  expectWrong("camera.position", "[[0, 5, 0, 0], [5, 0, 5, 0]]", 4, 5, "camera up is parallel");
  expectWrong("mesh.cup.scale", "[[0, -1], [2, 1]]", 0, 1, "scale is 0, must not be");
  expectWrong("mesh.cup.matrix", "[[0, 1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], [9, 0,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]]",
              8, 9, "mesh 'cup': the transform cannot be inverted");
  expectWrong("volume.smoke.opacity", "[[0, 0, 0.5, 9, 0.5], [4, 0, 0.5, -3, 0.5]]", 3, 4,
              "opacity has the value -3 after 0, must be ascending");
  expectWrong("shadows.seed", "[[0, 1], [9, -10]]", 0, 9, "seed is -10, must be in [0, 999999]");
}

TEST_F(AnimatedScene, RefusesWhatTheObjectCannotHave) {
  SceneReader scenes = reader(animate("light.sun.position", "[[0, 1, 2, 3]]"));
  expectError([&] { scenes.frame(3); }, "frame 3: 'position' is of lights of type spot, omni", kFirstLine + 1, 7);
}

TEST_F(AnimatedScene, LeavesErrorsOfTheFileWhereTheyAre) {
  SceneReader scenes = reader("[shadows]\nmap_size = 1\n" + animate("camera.fov", "[[0, 40]]"));
  expectError([&] { scenes.frame(0); }, "map_size is 1, must be in", kFirstLine + 1, 12);
}

}  // namespace
}  // namespace cdsm::io
