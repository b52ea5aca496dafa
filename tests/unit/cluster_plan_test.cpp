// SPDX-License-Identifier: Apache-2.0
// Which objects are clustered at all: for queries all that the light reaches, for pictures those whose shadow may be
// seen.
#include "cluster/cluster_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cluster_parts.hpp"

namespace cdsm::cluster {
namespace {

using reference::Random;

bool plans(const Scene& scene, unsigned object, Purpose purpose) {
  for (const Light& light : scene.lights) {
    const LightPlan plan = planOf(scene, light, purpose);
    if (std::find(plan.objects.begin(), plan.objects.end(), object) != plan.objects.end()) return true;
  }
  return false;
}

/// A floor with a cube on it, in the light of a spot above, seen from above.
Scene floorScene(float opacity = 1.0f) {
  Scene scene = reference::emptyScene();
  scene.camera.position = {0, 2, 6};
  scene.shadows.clusters = 4;
  addFloor(scene, 0.0f, 3.0f, opacity);
  addCube(scene, {0, 0.5f, 0}, 0.5f);
  return scene;
}

TEST(ClusterPlan, LeavesOutFloorsForPicturesAlone) {
  const Scene scene = floorScene();
  EXPECT_FALSE(plans(scene, 0, Purpose::Image));
  EXPECT_TRUE(plans(scene, 0, Purpose::Points));
  EXPECT_TRUE(plans(scene, 1, Purpose::Image));
  EXPECT_TRUE(plans(scene, 1, Purpose::Points));
}

TEST(ClusterPlan, KeepsFloorsWhoseShadowIsSeen) {
  Scene below = floorScene();
  below.camera.position = {0, -2, 6};
  EXPECT_TRUE(plans(below, 0, Purpose::Image));
  Scene lightBelow = floorScene();
  lightBelow.lights.front().position.y = -4;
  EXPECT_TRUE(plans(lightBelow, 0, Purpose::Image));
  Scene inPlane = floorScene();
  inPlane.camera.position = {0, 0, 6};
  EXPECT_TRUE(plans(inPlane, 0, Purpose::Image));
  Scene behind = floorScene();
  addCube(behind, {0, -1, 0}, 0.1f);  // seen through glass alone
  EXPECT_FALSE(plans(behind, 0, Purpose::Image));
  behind.materials.front().opacity = 0.5f;
  EXPECT_TRUE(plans(behind, 0, Purpose::Image));
}

/// A floor of glass shadows nothing either, unless something is under it.
TEST(ClusterPlan, OfTranslucentFloors) {
  EXPECT_TRUE(plans(floorScene(0.5f), 0, Purpose::Points));
  Scene under = floorScene(0.5f);
  under.meshes[1].worldFromObject[3].y = 0.3f;  // reaches through
  EXPECT_TRUE(plans(under, 0, Purpose::Image));
}

TEST(ClusterPlan, WhatHangsBelowTheEdgeIsSeen) {
  Scene scene = floorScene();
  scene.camera.position = {0, 8, 8};
  for (const float z : {1.0f, 2.3f, 2.9f, 3.2f}) {  // the cube reaches from y = -1 to 0 and half a unit to each side
    scene.meshes[1].worldFromObject = moved({0, -0.5f, z});
    EXPECT_EQ(plans(scene, 0, Purpose::Image), z > 2.0f) << z;
  }
  Scene partly = floorScene();
  partly.meshes[1].worldFromObject = moved({0, 0.2f, 0});  // a part of it under the lid
  EXPECT_FALSE(plans(partly, 0, Purpose::Image));
}

/// The lid must be whole: not a floor with a hole.
TEST(ClusterPlan, FloorsWithHolesHideNothing) {
  Scene scene = floorScene();
  reference::MeshParts ring;
  for (const float half : {3.0f, 1.0f})
    for (const glm::vec2& corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      ring.positions.emplace_back(half * corner.x, 0.0f, half * corner.y);
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned next = (i + 1) % 4;
    ring.triangles.emplace_back(i, next, i + 4);
    ring.triangles.emplace_back(next, next + 4, i + 4);
  }
  scene.meshes[0].data = std::make_shared<const MeshData>(ring);
  scene.meshes[1].worldFromObject = moved({0, -0.7f, 0});
  EXPECT_TRUE(plans(scene, 0, Purpose::Image));
}

/// Points may be anywhere: nothing in the light is missing, however flat the scene and whatever rounding does to it.
TEST(ClusterPlan, ForPointsHasAllThatTheLightReaches) {
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    Scene scene = reference::emptyScene();
    scene.shadows.clusters = 4;
    const int objects = random.integer(1, 3);
    for (int k = 0; k < objects; ++k) {
      const glm::vec3 size(random.uniform(0.2, 2), random.uniform(0.2, 2), random.uniform(0.2, 2));
      const glm::vec3 position = float(random.uniform(0, 3)) * random.direction();
      const int material = reference::addMaterial(scene, glm::vec3(1), 1.0f);
      const glm::mat4 pose = i % 2 ? randomPose(random, size, position) : moved(position);
      if (i % 3)
        reference::addMesh(scene, reference::quadMesh(glm::vec3(0.1f, 0.7f, 0.3f), {size.x, 0, 0}, {0, 0, size.z}),
                           material, pose);
      else
        reference::addMesh(scene, reference::boxMesh(-0.3f * size, 0.7f * size), material, pose);
    }
    for (const Light& light :
         {omniAt({0.2f, 12.0f, -0.1f}), sunAlong(random.direction()), spotAt({0, 20, 1}, glm::vec3(0), 40.0f)})
      EXPECT_EQ(planOf(scene, light, Purpose::Points).objects.size(), scene.meshes.size())
          << i << ", light of type " << int(light.type);
  }
}

TEST(ClusterPlan, LeavesOutWhatTheLightDoesNotReach) {
  Scene scene = reference::emptyScene();
  scene.shadows.clusters = 4;
  addCube(scene, {0, 0, 0}, 0.3f);
  addCube(scene, {6, 0, 0}, 0.3f);  // outside of the cone of 20 degrees
  addCube(scene, {0, 8, 0}, 0.3f);  // behind the light
  addCube(scene, {0, 1, 0}, 0.3f, 0.0f);
  for (const Purpose purpose : {Purpose::Image, Purpose::Points}) {
    EXPECT_TRUE(plans(scene, 0, purpose));
    EXPECT_FALSE(plans(scene, 1, purpose));
    EXPECT_FALSE(plans(scene, 2, purpose));
    EXPECT_FALSE(plans(scene, 3, purpose));
  }
}

TEST(ClusterPlan, LeavesOutWhoseShadowFallsBesideThePicture) {
  Scene scene = reference::emptyScene();
  scene.camera.position = {0, 1, 6};
  scene.camera.fov = 20.0f;
  scene.shadows.clusters = 4;
  scene.lights = {sunAlong({0, -1, 0})};
  addCube(scene, {0, 0, 0}, 0.3f);
  addCube(scene, {4, 0, 0}, 0.3f);
  addCube(scene, {0, 5, 0}, 0.3f);  // above the picture, its shadow in it
  EXPECT_TRUE(plans(scene, 0, Purpose::Image));
  EXPECT_FALSE(plans(scene, 1, Purpose::Image));
  EXPECT_TRUE(plans(scene, 2, Purpose::Image));
  EXPECT_TRUE(plans(scene, 1, Purpose::Points));
}

TEST(ClusterPlan, WithoutClustersHasAllThatCasts) {
  Scene scene = floorScene();
  addCube(scene, {100, 0, 0}, 0.3f);
  addCube(scene, {1, 0, 0}, 0.3f, 0.0f);
  scene.meshes[1].shadow.casts = false;
  const LightPlan plan = planWithoutClusters(scene, shapesOf(scene));
  EXPECT_EQ(plan.clusters, (LightClusters{{0, 2}}));
}

TEST(ClusterPlan, HasEachObjectOnceInAscendingOrder) {
  Random random(3);
  Scene scene = reference::emptyScene();
  for (int i = 0; i < 30; ++i) addCube(scene, 3.0f * random.direction(), float(random.uniform(0.05, 0.4)));
  for (const int most : {2, 4, 8})
    for (const Light& light : {omniAt({0, 0, 0}), sunAlong({0.2f, -1, 0.1f}), spotAt({0, 9, 0}, glm::vec3(0), 30.0f)}) {
      scene.shadows.clusters = most;
      const LightPlan plan = planOf(scene, light, Purpose::Points);
      std::vector<unsigned> all;
      EXPECT_LE(plan.clusters.size(), std::size_t(most));
      for (const auto& cluster : plan.clusters) {
        EXPECT_TRUE(std::is_sorted(cluster.begin(), cluster.end()));
        all.insert(all.end(), cluster.begin(), cluster.end());
      }
      std::sort(all.begin(), all.end());
      EXPECT_EQ(all.size(), scene.meshes.size());
      EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
      EXPECT_TRUE(std::isfinite(errorOf(plan, plan.clusters)));
      EXPECT_TRUE(std::isinf(errorOf(plan, {{0, 1}})));
    }
}

/// Arrays that somebody else writes to: what is known of their shapes is of one revision.
TEST(KnownShapes, AreThoseOfTheRevision) {
  reference::MeshParts mesh = reference::partsOf(reference::boxMesh(glm::vec3(-1.0f), glm::vec3(1.0f)));
  std::vector<glm::vec3> centers{{0, 0, 0}};
  Scene scene = reference::emptyScene();
  const int material = reference::addMaterial(scene, glm::vec3(1), 1.0f);
  reference::addMesh(scene, mesh, material);
  reference::addSpheres(scene, {Array<glm::vec3>::view(centers.data(), 1), {1.0f}, {}}, material);
  auto data = std::make_shared<MeshData>(mesh);
  data->positions = Array<glm::vec3>::view(mesh.positions.data(), mesh.positions.size());
  scene.meshes[0].data = data;
  KnownShapes shapes;
  const auto reach = [&](unsigned object) { return objectShapes(scene, shapes)[object].corners[7].x; };
  EXPECT_EQ(reach(0), 1.0);
  EXPECT_EQ(reach(1), 1.0);
  for (glm::vec3& p : mesh.positions) p.x *= 3.0f;
  centers[0].x = 4.0f;
  ++scene.meshes[0].revision;
  ++scene.spheres[0].revision;
  EXPECT_EQ(reach(0), 3.0);
  EXPECT_EQ(reach(1), 5.0);
  shapes.keepOnly(scene);  // forgets the former revision
  for (glm::vec3& p : mesh.positions) p.x *= 2.0f;
  scene.meshes[0].revision = 0;
  EXPECT_EQ(reach(0), 6.0);
}

}  // namespace
}  // namespace cdsm::cluster
