// SPDX-License-Identifier: Apache-2.0
// Scene files: what is read from them, and where and how a wrong one is refused.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cdsm/error.hpp>

#include "io/scene_file.hpp"

namespace cdsm::io {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, with a closed mesh, an open one and a volume in it.
class SceneFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("cdsm_" + test + "_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    write("closed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("grid.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678");
  }

  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  Scene read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    write("scene.toml", text);
    return readScene((folder_ / "scene.toml").string(), overrides);
  }

  /// The error without the folder, or "" when there is none.
  std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
      read(text, overrides);
    } catch (const Error& error) {
      std::string what = error.what();
      const std::string prefix = folder_.string() + "/";
      return what.compare(0, prefix.size(), prefix) == 0 ? what.substr(prefix.size()) : what;
    }
    return "";
  }

  struct Case {
    std::string text;
    std::string begin;  ///< of the message, place included
    std::string part = "";
  };

  void expectComplaints(const std::vector<Case>& cases) {
    for (const Case& wrong : cases) {
      const std::string message = complaint(wrong.text);
      EXPECT_EQ(message.substr(0, wrong.begin.size()), wrong.begin) << message;
      EXPECT_NE(message.find(wrong.part), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }

  fs::path folder_;
};

const std::string kMaterial = "[[material]]\nname = 'm'\n";
const std::string kMesh = "[[mesh]]\nname = 'a'\nfile = 'closed.obj'\nmaterial = 'm'\n";
const std::string kVolume =
    "[[volume]]\nname = 'v'\nfile = 'grid.nrrd'\nopacity = [[0, 0.5]]\ncolor = [[0, 1, 1, 1]]\n";

TEST_F(SceneFile, OfOneCommentGivesTheDefaults) {
  const Scene scene = read("# nothing\n");
  EXPECT_EQ(scene.image.width, 720);
  EXPECT_EQ(scene.shadows.technique, "deep-shadow-map");
  EXPECT_TRUE(scene.lights.empty());
}

TEST_F(SceneFile, GivesSettingsToTheScene) {
  const Scene scene = read(R"(
[camera]
position = [1, 2.5, 3]
fov = 60
[image]
width = 64
ambient = [0.5, 0.25, 0]
supersampling = 2
[shadows]
technique = "shadow-rays"
memory = "atlas"
map_size = 128
tolerance = 0.5
filter = "nearest"
clusters = 4
cluster_distance = 0.5
stable = true
step = 0.25
bias = 0.125
)");
  EXPECT_EQ(scene.camera.position, glm::vec3(1, 2.5, 3));
  EXPECT_EQ(scene.camera.fov, 60.0f);
  EXPECT_EQ(scene.image.width, 64);
  EXPECT_EQ(scene.image.ambient, glm::vec3(0.5, 0.25, 0));
  EXPECT_EQ(scene.image.supersampling, 2);
  EXPECT_EQ(scene.shadows.technique, "shadow-rays");
  EXPECT_EQ(scene.shadows.memory, "atlas");
  EXPECT_EQ(scene.shadows.mapSize, 128);
  EXPECT_EQ(scene.shadows.tolerance, 0.5f);
  EXPECT_EQ(scene.shadows.filter, "nearest");
  EXPECT_EQ(scene.shadows.clusters, 4);
  EXPECT_EQ(scene.shadows.clusterDistance, 0.5f);
  EXPECT_TRUE(scene.shadows.stable);
  EXPECT_EQ(scene.shadows.step, 0.25f);
  EXPECT_EQ(scene.shadows.bias, 0.125f);
}

TEST_F(SceneFile, GivesObjectsToTheScene) {
  const Scene scene =
      read(kVolume + "boundary = 'a'\nshading = false\nunit_distance = 2\n" + kMesh + "interior_extinction = 2.0\n" +
           kMaterial + "opacity = 0.25\n" + "[[light]]\nname = 'key'\ncutoff = 12.5\n");
  ASSERT_EQ(scene.volumes.size(), 1u);
  EXPECT_EQ(scene.volumes[0].boundary, 0);
  EXPECT_FALSE(scene.volumes[0].shading);
  EXPECT_EQ(scene.volumes[0].transfer.unitDistance, 2.0f);
  EXPECT_EQ(scene.volumes[0].transfer.opacity[0].opacity, 0.5f);
  EXPECT_EQ(scene.volumes[0].transfer.color[0].color, glm::vec3(1));
  EXPECT_EQ(scene.volumes[0].data->size, glm::uvec3(2));
  EXPECT_EQ(scene.meshes.at(0).interiorExtinction, 2.0f);
  EXPECT_EQ(scene.materials.at(0).opacity, 0.25f);
  EXPECT_EQ(scene.lights.at(0).cutoff, 12.5f);
}

TEST_F(SceneFile, GivesShadowRolesToObjects) {
  const Scene plain = read(kMaterial + kMesh + kVolume);
  for (const ShadowRole& role : {plain.meshes.at(0).shadow, plain.volumes.at(0).shadow}) {
    EXPECT_TRUE(role.casts && role.receives);
    EXPECT_EQ(role.weight, 1.0f);
  }
  const Scene scene = read(kMaterial + kMesh + "casts_shadow = false\ncluster_weight = 1000\n" + kVolume +
                           "receives_shadow = false\ncluster_weight = 0.5\n");
  EXPECT_FALSE(scene.meshes.at(0).shadow.casts);
  EXPECT_TRUE(scene.meshes.at(0).shadow.receives);
  EXPECT_EQ(scene.meshes.at(0).shadow.weight, 1000.0f);
  EXPECT_TRUE(scene.volumes.at(0).shadow.casts);
  EXPECT_FALSE(scene.volumes.at(0).shadow.receives);
  EXPECT_EQ(scene.volumes.at(0).shadow.weight, 0.5f);
}

TEST_F(SceneFile, RefusesBadClustersAndShadowRoles) {
  expectComplaints({
      {"[shadows]\nclusters = 0\n", "scene.toml:2:12: clusters is 0, must be in [1, 64]"},
      {"[shadows]\nclusters = 65\n", "scene.toml:2:12: clusters is 65"},
      {"[shadows]\nclusters = 2.5\n", "scene.toml:2:12: clusters is a number with a fraction, must be an integer"},
      {"[shadows]\ncluster_distance = 0\n", "scene.toml:2:20: cluster_distance is 0, must be in (0, 2.83]"},
      {"[shadows]\ncluster_distance = 3\n", "scene.toml:2:20: cluster_distance is 3"},
      {"[shadows]\nstable = 1\n", "scene.toml:2:10: stable is an integer, must be true or false"},
      {kMaterial + kMesh + "casts_shadow = 0\n", "scene.toml:7:16: casts_shadow is an integer, must be true or false"},
      {kMaterial + kMesh + "cluster_weight = 0\n", "scene.toml:7:18: cluster_weight is 0, must be in (0, 1000]"},
      {kMaterial + kMesh + "cast_shadow = true\n", "scene.toml:7:1: unknown key 'cast_shadow'",
       "did you mean 'casts_shadow'?"},
      {kVolume + "receives_shadow = 'no'\n", "scene.toml:6:19: receives_shadow is a string, must be true or false"},
      {kVolume + "cluster_weight = nan\n", "scene.toml:6:18: cluster_weight is nan"},
      {kVolume + "cluster_weight = 1001\n", "scene.toml:6:18: cluster_weight is 1001"},
  });
}

TEST_F(SceneFile, ReadsAFileOnceHoweverItIsNamed) {
  const Scene scene = read(kMaterial + kMesh + "[[mesh]]\nname = 'b'\nfile = './x/../closed.obj'\nmaterial = 'm'\n");
  EXPECT_EQ(scene.meshes.at(0).data, scene.meshes.at(1).data);
}

TEST_F(SceneFile, ScalesThenTurnsThenMoves) {
  const Scene scene = read(kMaterial + kMesh + "position = [10, 0, 0]\nrotation = [0, 0, 2, 90]\nscale = [2, 1, 1]\n");
  const glm::vec4 moved =
      scene.meshes.at(0).worldFromObject * glm::vec4(1, 0, 0, 1);  // (2, 0, 0), (0, 2, 0), (10, 2, 0)
  EXPECT_NEAR(moved.x, 10.0f, 1e-6f);
  EXPECT_NEAR(moved.y, 2.0f, 1e-6f);
  EXPECT_NEAR(moved.z, 0.0f, 1e-6f);
}

TEST_F(SceneFile, TakesAMatrixRowByRow) {
  const Scene scene = read(kMaterial + kMesh + "matrix = [1, 0, 0, 7, 0, 2, 0, 8, 0, 0, 3, 9, 0, 0, 0, 1]\n");
  const glm::vec4 moved = scene.meshes.at(0).worldFromObject * glm::vec4(1, 1, 1, 1);
  EXPECT_EQ(moved, glm::vec4(8, 10, 12, 1));
}

TEST_F(SceneFile, AcceptsLaterKeysAtTheirDefaults) {
  EXPECT_EQ(complaint("[shadows]\ntransmittance = 'grey'\n"
                      "cache = 'none'\n" +
                      kMaterial + "transmission = [0, 0, 0]\n" + kVolume + "transmission = []\nboundary = ''\n"),
            "");
}

TEST_F(SceneFile, RefusesUnknownKeysAtTheirPlace) {
  expectComplaints({
      {"[[material]]\nname = 'm'\n  colour = 1\n", "scene.toml:3:3: unknown key 'colour' in [[material]]",
       "must be one"},
      {"[[light]]\nname = 'm'\ncolour = 1\n", "scene.toml:3:1: unknown key 'colour'", "did you mean 'color'?"},
      {"[shadow]\n", "scene.toml:1:2: unknown key 'shadow' in the scene", "did you mean 'shadows'?"},
      {"[camera]\nfvo = 3\n", "scene.toml:2:1: unknown key 'fvo'", ""},
      {"width = 3\n", "scene.toml:1:1: unknown key 'width'", "camera, image"},
  });
}

TEST_F(SceneFile, RefusesWrongTypesLengthsAndRanges) {
  expectComplaints({
      {"[camera]\nfov = '45'\n", "scene.toml:2:7: fov is a string, must be in (0, 180) degrees"},
      {"[camera]\nfov = 180\n", "scene.toml:2:7: fov is 180, must be in (0, 180)"},
      {"[camera]\nfov = nan\n", "scene.toml:2:7: fov is nan, must be"},
      {"[camera]\nposition = [0, inf, 0]\n", "scene.toml:2:16: position is inf, must be"},
      {"[camera]\nposition = [0, 1]\n", "scene.toml:2:12: position is an array of 2, must be an array of 3 numbers"},
      {"[camera]\nposition = [0, 1, true]\n", "scene.toml:2:19: position is a boolean, must be in [-1e+09, 1e+09]"},
      {"[image]\nwidth = 64.5\n",
       "scene.toml:2:9: width is a number with a fraction, must be an integer in [1, 16384]"},
      {"[image]\nwidth = 100000000000\n", "scene.toml:2:9: width is 1e+11, must be in [1, 16384]"},
      {"[shadows]\nmap_size = 4\n", "scene.toml:2:12: map_size is 4, must be in [8, 16384] texels"},
      {"[shadows]\nfilter = 'bilinaer'\n", "scene.toml:2:10: unknown filter 'bilinaer', did you mean 'bilinear'?"},
      {"camera = 3\n", "scene.toml:1:10: 'camera' is a value, must be a table [camera]"},
      {"[light]\nname = 'x'\n", "scene.toml:1:1: 'light' is something else, must be tables [[light]]"},
      {"light = [1]\n", "scene.toml:1:10: 'light' is something else"},
      {kVolume + "shading = 1\n", "scene.toml:6:11: shading is an integer, must be true or false"},
      {kMaterial + kMesh + "interior_extinction = -1\n",
       "scene.toml:7:23: interior_extinction is -1, must be at least 0"},
  });
}

TEST_F(SceneFile, RefusesMissingKeysDuplicatesAndUnknownNames) {
  expectComplaints({
      {"[[light]]\ncutoff = 3\n", "scene.toml:1:1: [[light]] has no 'name', must have one"},
      {"[[light]]\nname = ''\n", "scene.toml:2:8: name is empty"},
      {kMaterial + kMaterial, "scene.toml:4:8: material 'm' is already in line 2, names must differ"},
      {kMesh, "scene.toml:4:12: unknown material 'm', there are none"},
      {kMaterial + "[[mesh]]\nname = 'a'\nfile = 'closed.obj'\n", "scene.toml:3:1: [[mesh]] has no 'material'"},
      {kVolume + "boundary = 'cup'\n", "scene.toml:6:12: unknown mesh 'cup'"},
      {"[[volume]]\nname = 'v'\nfile = 'grid.nrrd'\ncolor = [[0, 1, 1, 1]]\n",
       "scene.toml:1:1: [[volume]] has no 'opacity'"},
  });
}

TEST_F(SceneFile, RefusesBadTransferFunctionsAndTransforms) {
  const std::string begin = "[[volume]]\nname = 'v'\nfile = 'grid.nrrd'\ncolor = [[0, 1, 1, 1]]\n";
  expectComplaints({
      {begin + "opacity = []\n", "scene.toml:5:11: opacity is an array of 0, must be an array of at least one point"},
      {begin + "opacity = [[1, 0], [0, 0]]\n", "scene.toml:5:20: opacity has the value 0 after 1, must be ascending"},
      {begin + "opacity = [[1, 1.5]]\n", "scene.toml:5:16: opacity is 1.5, must be in [0, 1]"},
      {begin + "opacity = [[1, 0, 0]]\n", "scene.toml:5:12: opacity is an array of 3, must be an array of 2"},
      {begin + "opacity = [1, 0]\n", "scene.toml:5:12: opacity is an integer, must be an array of 2"},
      {kVolume + "scale = 0\n", "scene.toml:6:9: scale is 0"},
      {kVolume + "scale = [1, 1]\n", "scene.toml:6:9: scale is an array of 2"},
      {kVolume + "rotation = [0, 0, 0, 3]\n", "scene.toml:6:12: rotation has an axis without length"},
      {kVolume + "scale = 1\nmatrix = [1]\n", "scene.toml:7:10: matrix and scale are given"},
      {kVolume + "matrix = [1, 2]\n", "scene.toml:6:10: matrix is an array of 2, must be an array of 16"},
      {kVolume + "matrix = [0,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]\n",
       "scene.toml:3:8: volume 'v': the transform cannot be"},
  });
  EXPECT_EQ(complaint(begin + "opacity = [[1, 0], [1, 1]]\n"), "") << "equal values are a step";
}

TEST_F(SceneFile, RefusesDegenerateCamerasLightsAndOpenMeshes) {
  expectComplaints({
      {"[camera]\nposition = [0, 0, 0]\n", "scene.toml:1:1: camera: position and target are the same point"},
      {"[camera]\nup = [0, 0, 1]\n", "scene.toml:1:1: camera up is parallel"},
      {"[[light]]\nname = 'x'\nposition = [0, 0, 0]\n", "scene.toml:1:1: light 'x': position and target"},
      {kMaterial + "[[mesh]]\nname = 'a'\nfile = 'open.obj'\nmaterial = 'm'\ninterior_extinction = 1\n",
       "scene.toml:5:8: mesh 'a' has 3 open edges, must be closed"},
      {kMaterial + "[[mesh]]\nname = 'a'\nfile = 'open.obj'\nmaterial = 'm'\n" + kVolume + "boundary = 'a'\n",
       "scene.toml:12:12: mesh 'a' has 3 open edges, must be closed to be the boundary of volume 'v'"},
  });
}

TEST_F(SceneFile, ReadsAllTypesOfLights) {
  const Scene scene = read(
      "[[light]]\nname = 'a'\ntype = 'omni'\nposition = [1, 2, 3]\ncolor = [1, 0, 0]\n"
      "[[light]]\nname = 'b'\ntype = 'directional'\ndirection = [0, 0, -2]\n"
      "[[light]]\nname = 'c'\ntype = 'directional'\n[[light]]\nname = 'd'\ntype = 'spot'\n");
  EXPECT_EQ(scene.lights.at(0).type, LightType::Omni);
  EXPECT_EQ(scene.lights.at(0).position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.lights.at(1).type, LightType::Directional);
  EXPECT_EQ(scene.lights.at(1).direction, glm::vec3(0, 0, -2));
  EXPECT_EQ(scene.lights.at(2).direction, glm::vec3(0, -1, 0)) << "the default";
  EXPECT_EQ(scene.lights.at(3).type, LightType::Spot);
}

TEST_F(SceneFile, RefusesKeysOfOtherTypesOfLights) {
  const std::string omni = "[[light]]\nname = 'x'\ntype = 'omni'\n";
  const std::string directional = "[[light]]\nname = 'x'\ntype = 'directional'\n";
  expectComplaints({
      {"[[light]]\nname = 'x'\ntype = 'area'\n", "scene.toml:3:8: unknown type 'area'"},
      {"[[light]]\nname = 'x'\ndirection = [0, 1, 0]\n",
       "scene.toml:3:13: 'direction' is of lights of type directional, must be left out of type spot, which has: "
       "position, target, cutoff"},
      {omni + "target = [0, 1, 0]\n", "scene.toml:4:10: 'target' is of lights of type spot"},
      {omni + "cutoff = 20\n",
       "scene.toml:4:10: 'cutoff' is of lights of type spot, must be left out of type omni, which has: position"},
      {directional + "position = [0, 1, 0]\n",
       "scene.toml:4:12: 'position' is of lights of type spot, omni, must be left out of type directional, which has: "
       "direction"},
      {directional + "cutoff = 20\n", "scene.toml:4:10: 'cutoff' is of"},
      {directional + "direction = [0, 0, 0]\n",
       "scene.toml:1:1: light 'x': direction has no length, must be a direction"},
      {directional + "direction = [0, nan, 0]\n", "scene.toml:4:17: direction is nan"},
  });
}

TEST_F(SceneFile, TakesAPatchByNumberOrWord) {
  EXPECT_EQ(read("[shadows]\npatch = 3\n").shadows.patch, 3);
  EXPECT_EQ(read("[shadows]\npatch = 'auto'\n").shadows.patch, ShadowSettings::kPatchAuto);
  expectComplaints({
      {"[shadows]\npatch = -1\n", "scene.toml:2:9: patch is -1, must be in [0, 64] texels"},
      {"[shadows]\npatch = 'all'\n", "scene.toml:2:9: patch must be \"auto\" or an integer in [0, 64] texels"},
      {"[shadows]\npatch = 1.5\n", "scene.toml:2:9: patch must be \"auto\" or an integer"},
      {"[shadows]\nsoftness = -1\n", "scene.toml:2:12: softness is -1, must be at least 0"},
      {"[shadows]\nsoftness_distance = 0\n", "scene.toml:2:21: softness_distance is 0, must be above 0"},
      {"[shadows]\nsoftness_exponent = 0\n", "scene.toml:2:21: softness_exponent is 0, must be above 0"},
      {"[shadows]\ntechnique = 'implicit-sphere'\n",
       "scene.toml:2:13: the technique implicit-sphere needs [[spheres]]"},
  });
}

TEST_F(SceneFile, ReadsTransmissions) {
  const Scene scene = read("[shadows]\ntransmittance = 'rgb'\n" + kMaterial + "transmission = [0, 0.5, 1]\n" + kMesh +
                           "interior_transmission = [1, 0, 0.25]\n" + kVolume + "transmission = 'color'\n");
  EXPECT_EQ(scene.shadows.transmittance, "rgb");
  EXPECT_EQ(scene.materials.at(0).transmission, glm::vec3(0.0f, 0.5f, 1.0f));
  EXPECT_EQ(scene.meshes.at(0).interiorTransmission, glm::vec3(1.0f, 0.0f, 0.25f));
  const TransferFunction& transfer = scene.volumes.at(0).transfer;
  ASSERT_EQ(transfer.transmission.size(), transfer.color.size());
  EXPECT_EQ(transfer.transmission[0].value, transfer.color[0].value);
  EXPECT_EQ(transfer.transmission[0].color, glm::min(transfer.color[0].color, glm::vec3(1.0f)));
  const Scene points = read(kVolume + "transmission = [[0, 1, 0, 0], [5, 0, 0.5, 0]]\n");
  EXPECT_EQ(points.volumes.at(0).transfer.transmission.at(1).color, glm::vec3(0.0f, 0.5f, 0.0f));
}

TEST_F(SceneFile, RefusesTransmissionsAtTheirPlace) {
  expectComplaints({
      {"[shadows]\ntransmittance = 'red'\n", "scene.toml:2:17: unknown transmittance 'red'"},
      {kMaterial + "transmission = [0, 2, 0]\n", "scene.toml:3:", "transmission"},
      {kVolume + "transmission = 'colour'\n", "scene.toml:6:16: unknown transmission 'colour'", "color"},
      {kVolume + "transmission = [[0, 1, 2, 0]]\n", "scene.toml:6:", "transmission"},
      {kVolume + "transmission = [[1, 0, 0, 0], [0, 0, 0, 0]]\n", "scene.toml:6:", "ascending"},
      {"[shadows]\ntechnique = 'shadow-map'\ntransmittance = 'rgb'\n", "scene.toml:2:13: the technique shadow-map",
       "must be 'grey'"},
  });
}

TEST_F(SceneFile, ReadsAmbientOcclusionOfSpheres) {
  write("two.xyz", "2\n\nC 0 0 0\nC 1 0 0\n");
  const std::string spheres = kMaterial + "[[spheres]]\nname = 's'\nfile = 'two.xyz'\nmaterial = 'm'\n";
  EXPECT_FALSE(read(spheres).ambientOcclusion);
  const auto plain = read(spheres + "[ambient_occlusion]\n").ambientOcclusion;
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->directions, 16);
  EXPECT_EQ(plain->distance, 0.7f);
  EXPECT_EQ(plain->resolution, 0);
  EXPECT_EQ(plain->strength, 1.0f);
  const auto other = read(spheres + "[ambient_occlusion]\ndirections = 32\nresolution = 64\n",
                          {"ambient_occlusion.distance=0.5", "ambient_occlusion.strength=2"})
                         .ambientOcclusion;
  EXPECT_EQ(other->directions, 32);
  EXPECT_EQ(other->distance, 0.5f);
  EXPECT_EQ(other->resolution, 64);
  EXPECT_EQ(other->strength, 2.0f);
  EXPECT_EQ(read(spheres, {"ambient_occlusion.resolution=auto"}).ambientOcclusion->resolution, 0);
}

TEST_F(SceneFile, RefusesWrongAmbientOcclusion) {
  const std::string table = "[ambient_occlusion]\n";
  expectComplaints({
      {table, "scene.toml:1:1: ambient_occlusion needs [[spheres]]"},
      {table + "directions = 300\n", "scene.toml:2:14: directions is 300, must be in [4, 256]"},
      {table + "distance = 0\n", "scene.toml:2:12: distance is 0, must be in (0, 2] longest sides"},
      {table + "resolution = 4\n", "scene.toml:2:14: resolution is 4, must be in [8, 256] cells"},
      {table + "resolution = 'fine'\n", "scene.toml:2:14: resolution must be \"auto\" or an integer in [8, 256] cells"},
      {table + "strength = -1\n", "scene.toml:2:12: strength is -1, must be at least 0"},
      {table + "distanse = 1\n", "scene.toml:2:1: unknown key 'distanse' in [ambient_occlusion]"},
      {"ambient_occlusion = 3\n",
       "scene.toml:1:21: 'ambient_occlusion' is a value, must be a table [ambient_occlusion]"},
  });
}

TEST_F(SceneFile, RefusesBrokenTomlAndMissingFiles) {
  expectComplaints({
      {"[camera\n", "scene.toml:1:8: ", "must be TOML"},
      {"[camera]\nfov = 1\nfov = 2\n", "scene.toml:3:", "must be TOML"},
      {"[image]\nwidth = \xff\n", "scene.toml:2:", "must be TOML"},
      {kMaterial + "[[mesh]]\nname = 'a'\nfile = 'none.obj'\nmaterial = 'm'\n", "none.obj"},
  });
  EXPECT_THROW(readScene((folder_ / "none.toml").string()), Error);
  EXPECT_THROW(readScene(folder_.string()), Error);
}

TEST_F(SceneFile, IsChangedByOverrides) {
  const std::string text = kMaterial + "[[light]]\nname = 'key'\n[[light]]\nname = 'fill.two'\n[image]\nwidth = 8\n";
  const Scene scene =
      read(text, {"image.width=64", "shadows.memory=atlas", "light.key.cutoff=25", "light.fill.two.position=[1, 2, 3]",
                  "material.m.opacity = 0.5", "camera.fov=30", "shadows.filter=\"nearest\"", "light.key.cutoff=26"});
  EXPECT_EQ(scene.image.width, 64);
  EXPECT_EQ(scene.shadows.memory, "atlas");
  EXPECT_EQ(scene.shadows.filter, "nearest");
  EXPECT_EQ(scene.lights.at(0).cutoff, 26.0f) << "the last one wins";
  EXPECT_EQ(scene.lights.at(1).position, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.materials.at(0).opacity, 0.5f);
  EXPECT_EQ(scene.camera.fov, 30.0f);
}

TEST_F(SceneFile, NamesTheOverrideThatIsWrong) {
  const std::string text = "[[light]]\nname = 'key'\n[[light]]\nname = 'fill'\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"image.width=0", "width is 0, must be in [1, 16384]"},
      {"image.width=wide", "width is a string, must be an integer"},
      {"image.width=1\nheight=3", "control characters"},
      {"image.widht=3", "unknown key 'widht' in [image], did you mean 'width'?"},
      {"imgae.width=3", "unknown table 'imgae', did you mean 'image'?"},
      {"light.kee.cutoff=3", "unknown light 'kee', must be one of: key, fill"},
      {"mesh.cup.scale=3", "unknown mesh 'cup', the scene has none"},
      {"light.cutoff=3", "the key must have the form light.NAME.KEY"},
      {"image.a.width=3", "the key must have the form image.KEY"},
      {"light.fill.name=key", "light 'key' is already in line 2"},
      {"animate.x.key=3", "'animate' has no dotted keys, its tables must be changed in the scene file"},
      {"ambient_occlusion.directions=3", "directions is 3, must be in [4, 256]"},
      {"width", "must be KEY=VALUE"},
      {"width=3", "must be KEY=VALUE with a dotted KEY"},
      {"=", "must be KEY=VALUE"},
      {"image.=3", "unknown key '' in [image]"},
  };
  for (const auto& [setting, part] : cases) {
    const std::string message = complaint(text, {setting});
    EXPECT_EQ(message.find("--set "), 0u) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks\n" << part;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace cdsm::io
