// SPDX-License-Identifier: Apache-2.0
// Every mesh format on the cube of tests/data/make_data.py, joining of vertices, and bad meshes.
#include "io/mesh_file.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "io/mesh_soup.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::dataFile;
using cdsm::test::expectError;
using cdsm::test::readBytes;
using cdsm::test::replaced;

/// Directed edges that have no opposite: none in a closed mesh.
std::size_t openEdges(const MeshData& mesh) {
  std::set<std::pair<unsigned, unsigned>> edges;
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.emplace(t[i], t[(i + 1) % 3]);
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](auto e) {
    return edges.count({e.second, e.first}) == 0;
  }));
}

/// By the divergence theorem; positive when the triangles face outwards.
double enclosedVolume(const MeshData& mesh) {
  double six = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
    six += glm::dot(glm::dvec3(mesh.positions[t.x]),
                    glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])));
  return six / 6.0;
}

class Cubes : public testing::TestWithParam<const char*> {};

TEST_P(Cubes, AreClosedAndHaveEightCorners) {
  const auto mesh = io::readMesh(dataFile(GetParam()));
  EXPECT_EQ(mesh->positions.size(), 8u);
  EXPECT_EQ(mesh->triangles.size(), 12u);
  EXPECT_TRUE(mesh->normals.empty());
  EXPECT_EQ(openEdges(*mesh), 0u);
  EXPECT_DOUBLE_EQ(enclosedVolume(*mesh), 1.0);
}

INSTANTIATE_TEST_SUITE_P(All, Cubes,
                         testing::Values("cube_seams.obj", "cube_ascii.ply", "cube_little.ply", "cube_big.ply",
                                         "cube_binary.stl", "cube_ascii.stl"));

TEST(MeshFile, KeepsNormalsThatEveryVertexHas) {
  const auto mesh = io::readMesh(dataFile("cube_normals.obj"));
  ASSERT_EQ(mesh->normals.size(), 24u);
  ASSERT_EQ(mesh->positions.size(), 24u);
  for (const glm::uvec3& t : mesh->triangles) {
    const glm::vec3 a = mesh->positions[t.x], b = mesh->positions[t.y], c = mesh->positions[t.z];
    EXPECT_EQ(mesh->normals[t.x], glm::normalize(glm::cross(b - a, c - a)));
  }
}

TEST(MeshFile, DropsNormalsThatSomeVerticesLack) {
  const test::TemporaryFolder folder;
  const std::string part =
      replaced(readBytes(dataFile("cube_normals.obj")), "f -8//1 -6//1 -5//1 -7//1", "f -8 -6 -5 -7");
  const auto mesh = io::readMesh(folder.write("part.obj", part));
  EXPECT_TRUE(mesh->normals.empty());
  EXPECT_EQ(openEdges(*mesh), 0u);
}

TEST(MeshFile, GltfNodesMoveScaleAndMirror) {
  for (const char* name : {"cubes.gltf", "cubes.glb"}) {
    const auto mesh = io::readMesh(dataFile(name));
    EXPECT_EQ(mesh->positions.size(), 16u) << name;
    EXPECT_EQ(mesh->triangles.size(), 24u) << name;
    EXPECT_EQ(openEdges(*mesh), 0u) << name;
    EXPECT_DOUBLE_EQ(enclosedVolume(*mesh), 1.0 + 8.0) << name;  // a mirrored cube faces outwards too
    glm::vec3 low(1e9f), high(-1e9f);
    for (const glm::vec3& p : mesh->positions) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_EQ(low, glm::vec3(-2, 0, 0)) << name;
    EXPECT_EQ(high, glm::vec3(1, 2, 7)) << name;
  }
}

TEST(MeshFile, LeavesOutWhatHasNoArea) {
  const test::TemporaryFolder folder;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 9 9 9\n";
  const auto mesh = io::readMesh(folder.write("a.obj", vertices + "f 1 2 3\nf 1 2 4\nf 1 1 2\nl 1 2\np 1\n"));
  EXPECT_EQ(mesh->triangles.size(), 1u);
  EXPECT_EQ(mesh->positions.size(), 3u);
  expectError([&] { io::readMesh(folder.write("b.obj", vertices + "f 1 2 4\nl 1 2\n")); }, "no triangle");
  expectError([&] { io::readMesh(folder.write("c.obj", vertices)); }, "");
}

TEST(MeshFile, ReadsNegativeIndicesPolygonsAndContinuedLines) {
  const test::TemporaryFolder folder;
  const auto mesh =
      io::readMesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0 # here\nv 1 1 0\r\nv 0 1 \\\n 0\nf -4 -3 \\\n-2 -1\n"));
  EXPECT_EQ(mesh->triangles.size(), 2u);
}

TEST(JoinCorners, TakesZerosOfEitherSignForOne) {
  const auto corner = [](float x, float y, float z) { return io::Corner{{x, y, z}, glm::vec3(0.0f)}; };
  const MeshData mesh = io::joinCorners({corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0),  //
                                         corner(-0.0f, 0, 0), corner(0, 1, -0.0f), corner(-1, 0, 0)});
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
}

class BadMesh : public testing::Test {
 protected:
  void expectRefused(const std::string& name, const std::string& bytes, const std::string& part, int line = 0) {
    const std::string path = folder.write(name, bytes);
    expectError([&] { io::readMesh(path); }, part, line);
  }
  void expectSpoiled(const std::string& name, const std::string& from, const std::string& to, const std::string& part,
                     int line = 0) {
    expectRefused(name, replaced(readBytes(dataFile(name)), from, to), part, line);
  }

  test::TemporaryFolder folder;
};

TEST_F(BadMesh, MissingEmptyOrUnknown) {
  for (const char* name : {"a.obj", "a.ply", "a.stl", "a.gltf", "a.glb"}) {
    expectError([&] { io::readMesh(folder.path(name)); }, "no such file");
    expectRefused(name, "", "empty");
  }
  expectRefused("a.fbx", "bytes", ".obj, .ply, .stl, .gltf and .glb");
  expectRefused("noise.stl", "bytes", "size does not match");
  expectRefused("noise.ply", "bytes", "not a PLY file");
  expectRefused("noise.gltf", "bytes", "JSON");
  expectRefused("noise.glb", "bytes", "not a binary glTF");
}

TEST_F(BadMesh, ObjIndicesThatPointNowhere) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectRefused("a.obj", vertices + "f 1 2 4\n", "vertex 4, but the file has 3", 4);
  expectRefused("a.obj", vertices + "f 1 2 -4\n", "vertex -4", 4);
  expectRefused("a.obj", vertices + "f 0 1 2\n", "not a face corner", 4);
  expectRefused("a.obj", vertices + "f 1 2 3000000000000000000000\n", "not a face corner", 4);
  expectRefused("a.obj", vertices + "f 1//1 2//1 3//1\n", "normal 1, but the file has 0", 4);
  expectRefused("a.obj", vertices + "f 1/7 2/7 3/7\n", "texture coordinate 7", 4);
  expectRefused("a.obj", vertices + "f a b c\n", "not a face corner", 4);
}

TEST_F(BadMesh, NumbersThatAreNone) {
  expectRefused("a.obj", "v 0 0 nan\n", "finite", 1);
  expectRefused("a.obj", "v 0 0 1e39\n", "finite", 1);
  expectRefused("a.obj", "v 0 0\n", "finite", 1);
  expectSpoiled("cube_ascii.ply", "1 0 1\n", "1 nan 1\n", "vertex 5 of 8");
  expectSpoiled("cube_ascii.stl", "vertex 0 1 0", "vertex 0 inf 0", "finite", 5);
  std::string stl = readBytes(dataFile("cube_binary.stl"));
  stl.replace(96, 4, "\0\0\xc0\x7f", 4);
  expectRefused("nan.stl", stl, "not finite");
  std::string bin = readBytes(dataFile("cubes.bin"));
  folder.write("cubes.bin", bin.replace(0, 4, "\0\0\xc0\x7f", 4));
  expectRefused("nan.gltf", readBytes(dataFile("cubes.gltf")), "not finite");
}

TEST_F(BadMesh, PlyCountsAndIndices) {
  expectSpoiled("cube_ascii.ply", "vertex 8", "vertex 7", "");
  expectSpoiled("cube_ascii.ply", "face 12", "face 13", "face 12 of 13");
  expectSpoiled("cube_little.ply", "face 12", "face 4000000000", "face 12 of 4000000000");
  expectSpoiled("cube_little.ply", "vertex 8", "vertex 99999999999999999999", "count", 4);
  expectSpoiled("cube_little.ply", "vertex 8", "vertex 400000000", "vertex");
  expectSpoiled("cube_ascii.ply", "\n3 0 2 3\n", "\n3 0 2 8\n", "face 0 of 12 (from 0) uses a vertex");
  expectSpoiled("cube_ascii.ply", "\n3 0 2 3\n", "\n3 0 2 -1\n", "face 0 of 12 (from 0) uses a vertex");
  std::string bytes = readBytes(dataFile("cube_little.ply"));
  bytes[bytes.size() - 1] = '\x7f';
  expectRefused("far.ply", bytes, "face 11 of 12 (from 0) uses a vertex");
}

TEST_F(BadMesh, AnyCutIsNoticed) {
  for (const char* name :
       {"cube_ascii.ply", "cube_little.ply", "cube_big.ply", "cube_binary.stl", "cube_ascii.stl", "cubes.glb"}) {
    const std::string bytes = readBytes(dataFile(name));
    // Texts may lose their last line end, and STL the solid's name.
    const std::size_t harmless = std::string(name) == "cube_ascii.stl" ? 6 : std::string(name) == "cube_ascii.ply";
    for (std::size_t kept = 1; kept + harmless < bytes.size(); ++kept) {
      const std::string path = folder.write(name, bytes.substr(0, kept));
      EXPECT_THROW(io::readMesh(path), Error) << name << " cut to " << kept << " bytes";
    }
  }
}

TEST_F(BadMesh, GltfThatPointsNowhere) {
  folder.write("cubes.bin", readBytes(dataFile("cubes.bin")));
  expectSpoiled("cubes.gltf", "\"cubes.bin\"", "\"none.bin\"", "no such file");
  expectSpoiled("cubes.gltf", "\"byteLength\": 168", "\"byteLength\": 169", "169 bytes");
  expectSpoiled("cubes.gltf", "\"byteLength\": 72", "\"byteLength\": 74", "beyond its buffer");
  expectSpoiled("cubes.gltf", "\"count\": 8", "\"count\": 9", "beyond its bufferView");
  expectSpoiled("cubes.gltf", "\"count\": 8", "\"count\": 7", "faces cannot be used");
  expectSpoiled("cubes.gltf", "\"count\": 36", "\"count\": 35", "multiple of 3");
  expectSpoiled("cubes.gltf", "\"count\": 36", "\"count\": -36", "count");
  expectSpoiled("cubes.gltf", "\"POSITION\": 0", "\"POSITION\": 5", "outside of accessors");
  expectSpoiled("cubes.gltf", "\"POSITION\": 0", "\"POSITION\": 1", "three 32 bit floats");
  expectSpoiled("cubes.gltf", "\"indices\": 1", "\"indices\": 0", "unsigned integers");
  expectSpoiled("cubes.gltf", "\"mesh\": 0", "\"mesh\": 1", "outside of meshes");
  expectSpoiled("cubes.gltf", "\"version\": \"2.0\"", "\"version\": \"1.0\"", "not glTF 2.0");
}

TEST_F(BadMesh, GltfNodesInACircle) {
  folder.write("cubes.bin", readBytes(dataFile("cubes.bin")));
  const std::string child = "\"mesh\": 0,\n   \"scale\"";
  expectSpoiled("cubes.gltf", child, "\"children\": [1], " + child, "circle");
  expectSpoiled("cubes.gltf", child, "\"children\": [2], " + child, "two parents");
  expectSpoiled("cubes.gltf", child, "\"children\": [3], " + child, "outside of nodes");
}

TEST_F(BadMesh, ReadersPrintNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  expectRefused("a.obj", "mtllib none.mtl\nv 0 0 0\n", "");
  expectRefused("a.gltf", "{\"asset\":{\"version\":\"2.0\"}}", "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
