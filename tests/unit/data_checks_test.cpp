// SPDX-License-Identifier: Apache-2.0
// DataChecks: what is known of data, and for how long. A test sees that data were not looked at again when they have
// been spoilt in the meantime and still pass.
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <cdsm/error.hpp>

#include "scene/data_checks.hpp"

namespace cdsm::scene {
namespace {

std::shared_ptr<MeshData> triangle() {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<MeshData>(mesh);
}

std::shared_ptr<VolumeData> voxel() {
  VolumeData grid;
  grid.size = {1, 1, 1};
  grid.voxels.resize(1);
  return std::make_shared<VolumeData>(grid);
}

TEST(DataChecks, LooksAtValidDataOnce) {
  DataChecks checks;
  const auto mesh = triangle();
  const auto volume = voxel();
  checks.requireValid(mesh, "mesh");
  checks.requireValid(volume, "volume");
  EXPECT_EQ(checks.openEdges(mesh), 3u);
  mesh->triangles = {};
  volume->voxels.clear();
  EXPECT_NO_THROW(checks.requireValid(mesh, "mesh"));
  EXPECT_NO_THROW(checks.requireValid(volume, "volume"));
  EXPECT_EQ(checks.openEdges(mesh), 3u);
}

TEST(DataChecks, LooksAtWrongDataAgain) {
  DataChecks checks;
  const auto mesh = triangle();
  mesh->triangles = {};
  EXPECT_THROW(checks.requireValid(mesh, "mesh"), Error);
  EXPECT_THROW(checks.requireValid(mesh, "mesh"), Error);
}

TEST(DataChecks, LooksAtEachOfSeveral) {
  DataChecks checks;
  checks.requireValid(triangle(), "mesh");
  const auto wrong = triangle();
  wrong->triangles = {{0, 1, 3}};
  EXPECT_THROW(checks.requireValid(wrong, "mesh"), Error);
}

TEST(DataChecks, ForgetsDataWhoseOwnerIsGone) {
  DataChecks checks;
  const auto mesh = triangle();
  // pointers with owners of their own, as if a new mesh had got the address of an old one
  checks.requireValid(std::shared_ptr<const MeshData>(std::make_shared<int>(), mesh.get()), "mesh");
  mesh->triangles = {};
  EXPECT_THROW(checks.requireValid(std::shared_ptr<const MeshData>(std::make_shared<int>(), mesh.get()), "mesh"),
               Error);
}

TEST(DataChecks, RemembersNothingOfDataWithoutAnOwner) {
  DataChecks checks;
  const auto mesh = triangle();
  const std::shared_ptr<const MeshData> bare(std::shared_ptr<void>(), mesh.get());
  checks.requireValid(bare, "mesh");
  EXPECT_EQ(checks.openEdges(bare), 3u);
  mesh->triangles = {};
  EXPECT_THROW(checks.requireValid(bare, "mesh"), Error);
}

}  // namespace
}  // namespace cdsm::scene
