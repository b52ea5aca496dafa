// SPDX-License-Identifier: Apache-2.0
// The slow reference against closed forms worked out by hand: it has to be right before anything is measured with it.
#include "reference/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/analytic_cases.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::reference {
namespace {

std::vector<Crossing> crossingsOf(const Mesh& mesh, const Ray& ray) {
  std::vector<Crossing> crossings;
  Surface(mesh).addCrossings(ray, 0, crossings);
  return crossings;
}

Mesh meshOf(MeshData data) {
  Mesh mesh;
  mesh.data = std::make_shared<const MeshData>(std::move(data));
  return mesh;
}

TEST(Reference, matchesEveryClosedForm) {
  for (const AnalyticCase& analytic : analyticCases()) {
    const World world(analytic.scene);
    for (const glm::vec3& point : analytic.points) {
      const glm::dvec3 p(point);
      ASSERT_TRUE(lit(analytic.scene.lights.front(), p)) << analytic.name;
      EXPECT_NEAR(transmittance(world, analytic.scene.lights.front(), p), analytic.exact(p), analytic.discrete)
          << analytic.name << " at " << p.x << " " << p.y << " " << p.z;
    }
    for (const glm::vec3& point : unlitPoints(analytic.scene.lights.front())) {
      EXPECT_FALSE(lit(analytic.scene.lights.front(), glm::dvec3(point))) << analytic.name;
    }
  }
}

TEST(Reference, homogeneousSlabByHand) {
  Scene scene = emptyScene();
  const Field filled = [](const glm::dvec3&) { return 1.0; };
  addVolume(scene, makeVolume(VoxelType::UInt8, glm::uvec3(4), glm::vec3(-1.0f), glm::vec3(1.0f), filled),
            constantOpacity(0.5f, 1.0f));
  EXPECT_NEAR(transmittance(scene, scene.lights[0], {0.0, -2.0, 0.0}), 0.25, 1e-12);  // 2 units at 0.5 per unit
  EXPECT_NEAR(transmittance(scene, scene.lights[0], {0.0, 0.0, 0.0}), 0.5, 1e-12);
  EXPECT_NEAR(transmittance(scene, scene.lights[0], {0.0, 1.5, 0.0}), 1.0, 1e-12);
}

TEST(Reference, countsSharedEdgesAndVerticesOnce) {
  const Mesh box = meshOf(boxMesh(glm::vec3(-1.0f), glm::vec3(1.0f)));
  const glm::dvec3 origin(0.0, 5.0, 0.0);
  EXPECT_EQ(crossingsOf(box, rayTowards(origin, glm::dvec3(0.0))).size(), 2u);  // on the diagonals of both faces
  EXPECT_EQ(crossingsOf(box, rayTowards({5.0, 5.0, 5.0}, glm::dvec3(0.0))).size(), 2u);  // through two corners
  const Mesh sphere = meshOf(sphereMesh(1.0f, 16, 8, false));
  EXPECT_EQ(crossingsOf(sphere, rayTowards(origin, glm::dvec3(0.0))).size(), 2u);  // through both poles
}

TEST(Reference, everyRayThatEntersAClosedMeshLeavesIt) {
  const Mesh sphere = meshOf(sphereMesh(1.0f, 16, 8, false));
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 target(0.9f * random.direction());
    int sum = 0;
    for (const Crossing& crossing : crossingsOf(sphere, rayTowards(4.0 * glm::dvec3(random.direction()), target))) {
      sum += crossing.sign;
    }
    EXPECT_EQ(sum, 0);
  }
}

TEST(Reference, windsOnceInsideAndNotOutside) {
  const Mesh box = meshOf(boxMesh(glm::vec3(-1.0f), glm::vec3(1.0f)));
  const std::vector<Crossing> through = crossingsOf(box, rayTowards({0.1, 5.0, 0.2}, {0.1, 0.0, 0.2}));
  EXPECT_EQ(windingNumber(through, 0, 3.9), 0);
  EXPECT_EQ(windingNumber(through, 0, 4.1), 1);
  EXPECT_EQ(windingNumber(through, 0, 6.1), 0);
  const std::vector<Crossing> fromInside = crossingsOf(box, rayTowards({0.1, 0.0, 0.2}, {0.1, 5.0, 0.2}));
  EXPECT_EQ(windingNumber(fromInside, 0, 0.5), 1);
  EXPECT_EQ(windingNumber(fromInside, 0, 1.5), 0);
}

TEST(Reference, meshesFaceOutwards) {
  for (const MeshData& data : {boxMesh(glm::vec3(-1.0f), glm::vec3(1.0f)), sphereMesh(1.0f, 16, 8, true)}) {
    for (const glm::uvec3& t : data.triangles) {
      const glm::vec3& a = data.positions[t.x];
      const glm::vec3 normal = glm::cross(data.positions[t.y] - a, data.positions[t.z] - a);
      EXPECT_GT(glm::dot(normal, a + data.positions[t.y] + data.positions[t.z]), 0.0f);
    }
  }
}

TEST(Reference, coneHasAHardEdge) {
  const Light light = keyLight();  // 20 degrees, at height 4
  const double radius = 4.0 * std::tan(glm::radians(20.0));
  EXPECT_TRUE(lit(light, {radius - 1e-6, 0.0, 0.0}));
  EXPECT_FALSE(lit(light, {radius + 1e-6, 0.0, 0.0}));
  EXPECT_FALSE(lit(light, {0.0, 4.5, 0.0}));
}

TEST(Reference, visibilityEndsInTheTransmittanceAndNeverRises) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const World world(randomScene(seed));
    for (const Light& light : world.scene.lights) {
      const glm::dvec3 behind = -2.0 * glm::dvec3(light.position);
      const Visibility v = visibility(world, light, behind - glm::dvec3(light.position));
      EXPECT_EQ(v.front(), std::make_pair(0.0, 1.0));
      EXPECT_NEAR(v.back().second, transmittance(world, light, behind, kEngineStep), 1e-6) << "seed " << seed;
      for (std::size_t i = 1; i < v.size(); ++i) {
        EXPECT_LE(v[i].second, v[i - 1].second);
        EXPECT_GE(v[i].first, v[i - 1].first);
      }
    }
  }
}

TEST(Reference, pixelOfALitSheetByHand) {
  Scene scene = emptyScene();
  scene.camera.position = {0.0f, 2.0f, 0.0f};
  scene.camera.up = {0.0f, 0.0f, -1.0f};
  scene.image.background = glm::vec3(0.2f);
  Material& material = scene.materials[static_cast<std::size_t>(addMaterial(scene, {0.5f, 0.4f, 0.3f}, 0.75f))];
  material.specular = glm::vec3(0.25f);
  material.shininess = 8.0f;
  addMesh(scene, stackMesh(1, 0.0f, 1.0f, 3.0f), 0);
  // Seen and lit along the normal: k_d (i_a + 1) + k_s, over the background.
  const glm::dvec4 middle = pixel(scene, 24.0, 16.0);
  const glm::dvec3 expected = 0.75 * (glm::dvec3(0.5, 0.4, 0.3) * 1.1 + 0.25) + 0.25 * 0.2;
  EXPECT_LT(glm::length(glm::dvec3(middle) - expected), 1e-6);
  EXPECT_NEAR(middle.w, 0.75, 1e-7);
}

TEST(Reference, pixelOfAMediumByHand) {
  Scene scene = emptyScene();
  scene.shadows.technique = "none";
  scene.camera.position = {0.0f, 0.0f, 5.0f};
  const int mesh = addMesh(scene, boxMesh({-1.0f, -1.0f, -0.5f}, {1.0f, 1.0f, 0.5f}), addMaterial(scene, {}, 0.0f));
  scene.meshes[static_cast<std::size_t>(mesh)].interiorExtinction = 2.0f;
  scene.meshes[static_cast<std::size_t>(mesh)].interiorColor = {1.0f, 0.5f, 0.25f};
  const glm::dvec4 middle = pixel(scene, 24.0, 16.0);
  const double opacity = 1.0 - std::exp(-2.0);
  EXPECT_NEAR(middle.w, opacity, 1e-9);
  EXPECT_LT(glm::length(glm::dvec3(middle) - opacity * 1.1 * glm::dvec3(1.0, 0.5, 0.25)), 1e-6);
}

TEST(Reference, leavesOutWhatCastsNoShadow) {
  Scene scene = emptyScene();
  const Field filled = [](const glm::dvec3&) { return 1.0; };
  addVolume(scene, makeVolume(VoxelType::UInt8, glm::uvec3(4), glm::vec3(-1.0f), glm::vec3(1.0f), filled),
            constantOpacity(0.5f, 1.0f));
  scene.volumes[0].boundary = addMesh(scene, boxMesh(glm::vec3(-0.5f), glm::vec3(0.5f)), addMaterial(scene, {}, 0.25f));
  scene.meshes[0].interiorExtinction = 2.0f;
  const glm::dvec3 below(0.01, -2.0, 0.02);
  const double slant = glm::length(below - glm::dvec3(0.0, 4.0, 0.0)) / 6.0;
  const double mesh = 0.75 * 0.75 * std::exp(-2.0 * slant), volume = std::pow(0.5, slant);
  EXPECT_NEAR(transmittance(scene, scene.lights[0], below), mesh * volume, 1e-9);
  scene.volumes[0].shadow.casts = false;
  EXPECT_NEAR(transmittance(scene, scene.lights[0], below), mesh, 1e-9);
  scene.meshes[0].shadow.casts = false;
  EXPECT_EQ(transmittance(scene, scene.lights[0], below), 1.0);
  scene.volumes[0].shadow.casts = true;
  EXPECT_NEAR(transmittance(scene, scene.lights[0], below), volume, 1e-9) << "the mesh still cuts";
}

TEST(Reference, lightsWhatReceivesNoShadow) {
  Scene scene = emptyScene();
  scene.camera.position = {0.0f, 2.0f, 0.0f};
  scene.camera.up = {0.0f, 0.0f, -1.0f};
  addMesh(scene, stackMesh(1, 0.0f, 1.0f, 3.0f), addMaterial(scene, glm::vec3(0.5f), 1.0f));
  addMesh(scene, stackMesh(1, 3.0f, 1.0f, 3.0f), addMaterial(scene, glm::vec3(0.5f), 1.0f));  // above the camera
  EXPECT_NEAR(pixel(scene, 24.0, 16.0).x, 0.5 * 0.1, 1e-6) << "ambient light alone";
  scene.meshes[0].shadow.receives = false;
  EXPECT_NEAR(pixel(scene, 24.0, 16.0).x, 0.5 * 1.1, 1e-6);
}

TEST(Reference, firstPixelIsAtTheTopLeft) {
  const Scene scene = emptyScene();
  const Ray ray = cameraRay(scene, 0.5, 0.5);
  EXPECT_LT(ray.direction.x, 0.0);
  EXPECT_GT(ray.direction.y, cameraRay(scene, 0.5, 31.5).direction.y);
}

TEST(Reference, normalOfAShearedVolumeIsInWorldSpace) {
  Scene scene = emptyScene();
  glm::mat4 shear(1.0f);
  shear[1][0] = 0.5f;
  shear[2] = {0.0f, 0.25f, 2.0f, 0.0f};
  const glm::dvec3 gradient(0.3, -0.4, 0.5);
  const Field linear = [&](const glm::dvec3& p) {  // linear in world space: p is in object space
    return 0.5 + 0.2 * glm::dot(gradient, glm::dvec3(glm::dmat4(shear) * glm::dvec4(p, 1.0)));
  };
  addVolume(scene, makeVolume(VoxelType::Float32, {8, 9, 10}, glm::vec3(-1.0f), glm::vec3(1.0f), linear),
            linearOpacity(1.0, 0.5f, 1.0f), shear);
  const World world(scene);
  EXPECT_LT(glm::length(world.grids[0].normal({0.1, 0.05, -0.2}) - glm::normalize(gradient)), 1e-5);
  EXPECT_NEAR(world.grids[0].value({0.1, 0.05, -0.2}), 0.5 + 0.2 * glm::dot(gradient, {0.1, 0.05, -0.2}), 1e-6);
}

TEST(Reference, classifiesAfterInterpolating) {
  const TransferFunction transfer = linearOpacity(10.0, 0.5f, 1.0f);
  EXPECT_DOUBLE_EQ(opacityAt(transfer, -1.0), 0.0);
  EXPECT_DOUBLE_EQ(opacityAt(transfer, 5.0), 0.25);
  EXPECT_DOUBLE_EQ(opacityAt(transfer, 99.0), 0.5);
}

}  // namespace
}  // namespace cdsm::reference
