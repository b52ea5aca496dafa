// SPDX-License-Identifier: Apache-2.0
// [[spheres]] of scene files: what becomes of its keys, from frame to frame too, and where bad ones are refused.
#include <cmath>

#include "io/scene_file.hpp"
#include "reference/parts.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::expectError;

class SceneSpheres : public testing::Test {
 protected:
  SceneSpheres() { folder_.write("two.xyz", "2\n\nN 0 0 0\nC 1 2 3\n"); }

  std::string scene(const std::string& keys, const std::string& more = "") {
    return folder_.write("scene.toml",
                         "[[material]]\nname = 'm'\n[[spheres]]\nname = 's'\nfile = 'two.xyz'\n"
                         "material = 'm'\n" +
                             keys + "\n" + more);
  }
  Spheres read(const std::string& keys) { return io::readScene(scene(keys)).spheres.at(0); }
  void expectBad(const std::string& keys, const std::string& part, int line = 7) {
    expectError([&] { read(keys); }, part, line);
  }

  test::TemporaryFolder folder_;
};

TEST_F(SceneSpheres, HaveTheirElementsLooksAtFirst) {
  const Spheres spheres = read("");
  EXPECT_EQ(spheres.name, "s");
  EXPECT_EQ(reference::valuesOf(spheres.data->radii), (std::vector<float>{1.55f, 1.7f}));
  EXPECT_EQ(spheres.data->colors.size(), 2u);
  EXPECT_EQ(spheres.worldFromObject, glm::mat4(1.0f));
  EXPECT_TRUE(spheres.shadow.casts && spheres.shadow.receives);
}

TEST_F(SceneSpheres, TakeTheirKeys) {
  const Spheres spheres = read(
      "radius = 0.25\ncolor = [0.5, 0, 1]\ncasts_shadow = false\nreceives_shadow = false\n"
      "cluster_weight = 2\nposition = [1, 0, 0]\nrotation = [0, 0, 1, 90]\nscale = 2");
  EXPECT_EQ(spheres.data->radii[1], 0.25f);
  EXPECT_EQ(spheres.data->colors[1], glm::vec3(0.5f, 0.0f, 1.0f));
  EXPECT_FALSE(spheres.shadow.casts || spheres.shadow.receives);
  EXPECT_EQ(spheres.shadow.weight, 2.0f);
  const glm::vec3 moved(spheres.worldFromObject * glm::vec4(1, 2, 3, 1));  // (2, 4, 6), (-4, 2, 6), (-3, 2, 6)
  EXPECT_LT(glm::distance(moved, glm::vec3(-3, 2, 6)), 1e-5f);
}

TEST_F(SceneSpheres, MayBeMirroredAndTurnedByAMatrix) {
  const Spheres spheres =
      read("matrix = [0, -0.7071068, 0.7071068, 0, 0, 0.7071068, 0.7071068, 0, 1, 0, 0, 0, 0, 0, 0, 1]");
  EXPECT_EQ(spheres.worldFromObject[0], glm::vec4(0, 0, 1, 0));
  read("scale = -2");
}

TEST_F(SceneSpheres, AreRefusedAtTheirPlace) {
  expectBad("radius = -1", "radius is -1, must be at least 0");
  expectBad("radius = nan", "radius is nan");
  expectBad("radius = 'big'", "radius is a string");
  expectBad("color = 'elements'", "unknown color 'elements', did you mean 'element'?");
  expectBad("color = [1, 0]", "color is an array of 2");
  expectBad("color = [1, 0, -1]", "color is -1");
  expectBad("waters = 0", "waters is an integer");
  expectBad("scale = [2, 2, 2]", "scale is an array");
  expectBad("scale = 0", "scale is 0, must not be");
  expectBad("matrix = [1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]", "must scale all axes alike");
  expectBad("matrix = [1, 0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]", "must scale all axes alike");
  expectBad("matrix = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]", "cannot be inverted");
  expectBad("interior_extinction = 1", "unknown key 'interior_extinction'");
  expectError([&] { io::readScene(folder_.write("s.toml", "[[spheres]]\nname = 's'\nfile = 'two.xyz'\n")); },
              "[[spheres]] has no 'material'", 1);
}

TEST_F(SceneSpheres, OfOneLookShareTheirData) {
  const std::string same = "[[spheres]]\nname = 't'\nfile = './x/../two.xyz'\nmaterial = 'm'\n";
  const Scene alike = io::readScene(scene("", same));
  EXPECT_EQ(alike.spheres.at(0).data, alike.spheres.at(1).data);
  const Scene unlike = io::readScene(scene("", same + "radius = 1\n"));
  EXPECT_NE(unlike.spheres.at(0).data, unlike.spheres.at(1).data);
}

TEST_F(SceneSpheres, KeepTheirDataUntilTheirLookChanges) {
  io::SceneReader reader(scene("radius = 1",
                               "[[animate]]\nkey = 'spheres.s.radius'\nframes = [[1, 1], [3, 3]]\n"
                               "[[animate]]\nkey = 'spheres.s.position'\nframes = [[0, 0, 0, 0], [1, 1, 0, 0]]\n"));
  const Scene first = reader.frame(0), second = reader.frame(1), third = reader.frame(2);
  EXPECT_EQ(first.spheres.at(0).data, second.spheres.at(0).data);
  EXPECT_EQ(second.spheres.at(0).worldFromObject[3].x, 1.0f);
  EXPECT_NE(second.spheres.at(0).data, third.spheres.at(0).data);
  EXPECT_EQ(third.spheres.at(0).data->radii[0], 2.0f);
}

}  // namespace
