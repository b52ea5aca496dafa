// SPDX-License-Identifier: Apache-2.0
// Closedness and winding numbers of small meshes; the answers are by hand.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "reference/parts.hpp"
#include "scene/closed_mesh.hpp"

namespace cdsm::scene {
namespace {

/// A tetrahedron with a corner at the origin and one at 1 along each axis; triangles counter-clockwise from outside.
MeshData tetrahedron() {
  reference::MeshParts mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

/// The same triangles, each with three vertices of its own.
MeshData unjoined(const MeshData& mesh) {
  reference::MeshParts apart;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const unsigned first = static_cast<unsigned>(apart.positions.size());
    for (int corner = 0; corner < 3; ++corner) apart.positions.push_back(mesh.positions[triangle[corner]]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

const glm::mat4 kIdentity(1.0f);
const glm::dvec3 kInside(0.1, 0.2, 0.3);

TEST(OpenEdges, AClosedMeshHasNone) { EXPECT_EQ(openEdges(tetrahedron()), 0u); }

TEST(OpenEdges, EqualPositionsAreJoined) { EXPECT_EQ(openEdges(unjoined(tetrahedron())), 0u); }

TEST(OpenEdges, MinusZeroIsZero) {
  reference::MeshParts mesh = reference::partsOf(unjoined(tetrahedron()));
  mesh.positions[0] = {-0.0f, 0.0f, -0.0f};
  EXPECT_EQ(openEdges(mesh), 0u);
}

TEST(OpenEdges, AMissingTriangleLeavesThree) {
  reference::MeshParts mesh = reference::partsOf(tetrahedron());
  mesh.triangles.pop_back();
  EXPECT_EQ(openEdges(mesh), 3u);
}

TEST(OpenEdges, ATriangleTheWrongWayRoundCountsTwicePerEdge) {
  reference::MeshParts mesh = reference::partsOf(tetrahedron());
  std::swap(mesh.triangles[0].x, mesh.triangles[0].y);
  EXPECT_EQ(openEdges(mesh), 6u);
}

TEST(OpenEdges, TrianglesWithoutAreaDoNotMatter) {
  reference::MeshParts mesh = reference::partsOf(tetrahedron());
  mesh.triangles.push_back({0, 0, 0});
  mesh.triangles.push_back({1, 1, 2});
  EXPECT_EQ(openEdges(mesh), 0u);
}

TEST(OpenEdges, TwoBodiesThatShareAnEdgeAreClosed) {
  reference::MeshParts mesh = reference::partsOf(tetrahedron());
  const glm::mat4 halfTurn = glm::rotate(kIdentity, glm::radians(180.0f), {0, 0, 1});
  for (const glm::vec3& p : tetrahedron().positions) {
    // turned about z the edge from the origin to (0, 0, 1) stays; rounded, so that its ends are exactly equal
    mesh.positions.push_back(glm::round(glm::vec3(halfTurn * glm::vec4(p, 1.0f))));
  }
  for (const glm::uvec3& triangle : tetrahedron().triangles) mesh.triangles.push_back(triangle + 4u);
  EXPECT_EQ(openEdges(mesh), 0u);
}

TEST(WindingNumber, IsOneInsideAndZeroOutside) {
  EXPECT_NEAR(windingNumber(tetrahedron(), kIdentity, kInside), 1.0, 1e-12);
  EXPECT_NEAR(windingNumber(tetrahedron(), kIdentity, {0.4, 0.4, 0.4}), 0.0, 1e-12);
  EXPECT_NEAR(windingNumber(tetrahedron(), kIdentity, {-50.0, 3.0, 0.1}), 0.0, 1e-12);
}

TEST(WindingNumber, IsMinusOneInAMirroredMesh) {
  const glm::mat4 mirror = glm::scale(kIdentity, {-1, 1, 1});
  EXPECT_NEAR(windingNumber(tetrahedron(), mirror, {-0.1, 0.2, 0.3}), -1.0, 1e-12);
}

TEST(WindingNumber, FollowsTheTransform) {
  const glm::mat4 moved = glm::scale(glm::translate(kIdentity, {10, 0, 0}), glm::vec3(2));
  EXPECT_NEAR(windingNumber(tetrahedron(), moved, {10.2, 0.4, 0.6}), 1.0, 1e-12);
  EXPECT_NEAR(windingNumber(tetrahedron(), moved, kInside), 0.0, 1e-12);
}

TEST(WindingNumber, OfOneTriangleIsItsShareOfTheSphere) {
  reference::MeshParts mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_NEAR(windingNumber(mesh, kIdentity, glm::dvec3(0.0)), 1.0 / 8.0, 1e-12);  // one octant
}

}  // namespace
}  // namespace cdsm::scene
