// SPDX-License-Identifier: Apache-2.0
// OpenVDB files that the library itself writes: values, places and what is refused.
#include <cstring>

#include <openvdb/openvdb.h>

#include "io/volume_file.hpp"
#include "unit/io_test_files.hpp"

namespace {

using namespace cdsm;
using cdsm::test::expectError;

class VdbFiles : public testing::Test {
 protected:
  VdbFiles() { openvdb::initialize(); }

  std::string write(const openvdb::GridPtrVec& grids) const {
    openvdb::io::File(folder.path("a.vdb")).write(grids);
    return folder.path("a.vdb");
  }

  template <typename Grid>
  static typename Grid::Ptr make(const char* name, typename Grid::ValueType background) {
    auto grid = Grid::create(background);
    grid->setName(name);
    return grid;
  }

  /// Voxels (-1, 10, 20) and (1, 11, 23) of a box of 3 x 2 x 4, values 2.5 and 4.5, background 0.5.
  static openvdb::FloatGrid::Ptr sparse(const char* name) {
    const auto grid = make<openvdb::FloatGrid>(name, 0.5f);
    grid->tree().setValue({-1, 10, 20}, 2.5f);
    grid->tree().setValue({1, 11, 23}, 4.5f);
    return grid;
  }

  test::TemporaryFolder folder;
};

float valueAt(const VolumeData& volume, std::size_t index) {
  float value;
  std::memcpy(&value, volume.voxels.data() + index * sizeof(float), sizeof(float));
  return value;
}

TEST_F(VdbFiles, BecomeDenseOverTheirActiveBox) {
  const auto volume = io::readVolume(write({sparse("density")}));
  ASSERT_EQ(volume->size, glm::uvec3(3, 2, 4));
  ASSERT_EQ(volume->type, VoxelType::Float32);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(valueAt(*volume, i), i == 0 ? 2.5f : i == 23 ? 4.5f : 0.5f) << i;
}

TEST_F(VdbFiles, LieWhereTransformAndIndexOriginSay) {
  const auto grid = sparse("density");
  // row vectors: x goes along -y, steps 0.5, 1 and 2, then a shift
  grid->setTransform(openvdb::math::Transform::createLinearTransform(
      openvdb::Mat4R(0.0, -0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 100.0, 200.0, 300.0, 1.0)));
  const glm::mat4 matrix = io::readVolume(write({grid}))->objectFromIndex;
  EXPECT_EQ(matrix[0], glm::vec4(0.0f, -0.5f, 0.0f, 0.0f));
  EXPECT_EQ(matrix[1], glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
  EXPECT_EQ(matrix[2], glm::vec4(0.0f, 0.0f, 2.0f, 0.0f));
  EXPECT_EQ(matrix[3], glm::vec4(110.0f, 200.5f, 340.0f, 1.0f));  // of voxel (-1, 10, 20)
}

TEST_F(VdbFiles, GridsAreChosenByName) {
  const auto ids = make<openvdb::Int32Grid>("ids", 0);
  ids->fill(openvdb::CoordBBox({0, 0, 0}, {1, 1, 1}), 7);
  const auto exact = make<openvdb::DoubleGrid>("exact", 0.0);
  exact->fill(openvdb::CoordBBox({0, 0, 0}, {0, 0, 2}), 0.1);
  const auto velocity = make<openvdb::Vec3SGrid>("velocity", openvdb::Vec3s(0.0f));
  velocity->tree().setValue({0, 0, 0}, openvdb::Vec3s(1.0f));
  const std::string path = write({velocity, ids, sparse("density"), exact});
  EXPECT_EQ(io::readVolume(path)->size, glm::uvec3(3, 2, 4));
  EXPECT_EQ(valueAt(*io::readVolume(path, {"ids", ""}), 0), 7.0f);
  EXPECT_EQ(valueAt(*io::readVolume(path, {"exact", ""}), 2), 0.1f);
  expectError([&] { io::readVolume(path, {"velocity", ""}); }, "\"velocity\" is of type vec3s");
  expectError(
      [&] {
        io::readVolume(path, {"smoke", ""});
      },
      "has no grid \"smoke\"; name one with grid = \"...\", its grids are: \"velocity\" (vec3s), \"ids\" (int32), "
      "\"density\" (float), \"exact\" (double)");
  const std::string floatless = write({ids});
  expectError([&] { io::readVolume(floatless); }, "has no grid of float");
}

TEST_F(VdbFiles, ThatHoldNoGridOfUsefulSize) {
  const std::string empty = write({make<openvdb::FloatGrid>("density", 0.0f)});
  expectError([&] { io::readVolume(empty); }, "no active voxels");
  for (const int far : {1500, 1 << 20, 0x7ffffff0}) {
    const auto grid = sparse("density");
    grid->tree().setValue({far, far, far}, 1.0f);
    const std::string path = write({grid});
    expectError([&] { io::readVolume(path); }, far == 1500 ? "3 are active" : "at most 2^34 voxels");
  }
  const auto nan = sparse("density");
  nan->tree().setValue({0, 10, 20}, std::numeric_limits<float>::quiet_NaN());
  const std::string path = write({nan});
  expectError([&] { io::readVolume(path); }, "voxel (1, 0, 0) is not a finite number");
  const auto frustum = sparse("density");
  frustum->setTransform(
      openvdb::math::Transform::createFrustumTransform(openvdb::BBoxd({0, 0, 0}, {9, 9, 9}), 0.5, 10.0, 1.0));
  const std::string cone = write({frustum});
  expectError([&] { io::readVolume(cone); }, "frustum");
}

TEST_F(VdbFiles, AnyCutIsNoticed) {
  const std::string bytes = test::readBytes(write({sparse("density")}));
  const std::string cut = folder.path("cut.vdb");
  for (std::size_t kept = 1; kept < bytes.size(); kept += 1 + kept / 50) {
    folder.write("cut.vdb", bytes.substr(0, kept));
    EXPECT_THROW(io::readVolume(cut), Error) << kept << " of " << bytes.size() << " bytes";
  }
  folder.write("cut.vdb", bytes.substr(0, bytes.size() - 1));
  EXPECT_THROW(io::readVolume(cut), Error);
  folder.write("cut.vdb", std::string(4000, 'x'));
  expectError([&] { io::readVolume(cut); }, "not an OpenVDB file");
}

}  // namespace
