// SPDX-License-Identifier: Apache-2.0
// Focused light cameras: all that casts in a cluster is in their pictures, a texel from the border, and behind their
// near planes; and the pictures are no larger than they need to be.
#include "cluster/focus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "cluster/light_camera.hpp"
#include "cluster_parts.hpp"
#include "scene/transform.hpp"

namespace cdsm::cluster {
namespace {

using reference::Random;

constexpr int kSize = 64;
/// Texels: single precision of a picture a thousand times smaller than its distance.
constexpr double kRounding = 0.25;

double row(const shared::float4& r, const glm::dvec3& p) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; }

/// A point where its texel would have to be looked up.
struct Seen {
  double border, depth, w;  ///< texels to the picture's border, negative outside
};

Seen seenIn(const MapView& map, const glm::dvec3& p) {
  const double w = row(map.view.pixelW, p), u = row(map.view.pixelU, p) / w, v = row(map.view.pixelV, p) / w;
  return {std::min({u, v, kSize - u, kSize - v}), row(map.view.depth, p), w};
}

/// Side of an omni light, as points are told apart in lookups.
unsigned sideOf(const Light& light, const glm::dvec3& p) {
  const glm::dvec3 way = p - glm::dvec3(light.position), size = glm::abs(way);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return unsigned(2 * axis + (way[axis] < 0.0));
}

bool inCone(const Light& light, const glm::dvec3& p) {
  if (light.type != LightType::Spot) return true;
  const glm::dvec3 way = p - glm::dvec3(light.position);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(light.target) - glm::dvec3(light.position));
  return glm::dot(way, axis) >= std::cos(glm::radians(double(light.cutoff))) * glm::length(way);
}

/// Points of the surfaces: corners, and more on the triangles.
std::vector<glm::dvec3> surfacePoints(const Scene& scene, const std::vector<unsigned>& objects, Random& random) {
  std::vector<glm::dvec3> points;
  for (const unsigned object : objects) {
    const Mesh& mesh = scene.meshes[object];
    const glm::dmat4 matrix(mesh.worldFromObject);
    for (const glm::uvec3& t : mesh.data->triangles)
      for (int i = 0; i < 8; ++i) {
        const double a = i == 0 ? 0.0 : std::sqrt(random.uniform(0, 1)), b = random.uniform(0, 1);
        const glm::dvec3 p = (1.0 - a) * glm::dvec3(mesh.data->positions[t.x]) +
                             a * (1.0 - b) * glm::dvec3(mesh.data->positions[t.y]) +
                             a * b * glm::dvec3(mesh.data->positions[t.z]);
        points.emplace_back(matrix * glm::dvec4(p, 1.0));
      }
  }
  return points;
}

void expectSeen(const Scene& scene, const Light& light, Random& random) {
  std::vector<unsigned> objects(scene.meshes.size());
  std::iota(objects.begin(), objects.end(), 0u);
  const std::vector<MapView> maps = focusedViews(scene, light, shapesOf(scene), objects, kSize);
  const double least = lightNearDepth(light, scene::worldBounds(scene));
  for (const glm::dvec3& p : surfacePoints(scene, objects, random)) {
    const double distance = glm::distance(p, glm::dvec3(light.position));
    if (!inCone(light, p) || (light.type != LightType::Directional && distance < 100.0 * least)) continue;
    int found = 0;
    for (const MapView& map : maps) {
      if (map.face != CDSM_FACE_ANY && map.face != sideOf(light, p)) continue;
      ++found;
      const Seen seen = seenIn(map, p);
      EXPECT_GT(seen.w, 0.0);
      EXPECT_GE(seen.border, 1.0 - kRounding) << p.x << " " << p.y << " " << p.z << ", maps " << maps.size();
      EXPECT_GT(seen.depth, map.view.nearDepth) << p.x << " " << p.y << " " << p.z << ", maps " << maps.size();
      EXPECT_LE(seen.depth, map.farDepth * (1.0 + 1e-5) + 1e-5);
    }
    EXPECT_EQ(found, 1) << p.x << " " << p.y << " " << p.z << ", maps " << maps.size();
  }
}

void addRandomObject(Scene& scene, Random& random, double reach) {
  const double kinds[4] = {1e-3, 0.1, 0.5, 4.0};
  const double size = kinds[random.integer(0, 3)];
  const bool flat = random.integer(0, 2) == 0;
  const glm::vec3 sizes(size * random.uniform(0.3, 1), size * random.uniform(0.3, 1), size * random.uniform(0.3, 1));
  const glm::mat4 pose = randomPose(random, sizes, float(random.uniform(0, reach)) * random.direction());
  const int material = reference::addMaterial(scene, glm::vec3(1), 1.0f);
  reference::addMesh(
      scene,
      flat ? reference::quadMesh(glm::vec3(0), {1, 0, 0}, {0, 0, 1}) : reference::boxMesh(glm::vec3(-1), glm::vec3(1)),
      material, pose);
}

TEST(Focus, SeesAllOfACluster) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = reference::emptyScene();
    const int count = random.integer(1, 4);
    const double reach = i % 2 ? 1.0 : 3.0;
    for (int k = 0; k < count; ++k) addRandomObject(scene, random, reach);
    const glm::vec3 position = float(random.uniform(0.0, 6.0)) * random.direction();
    for (const float cutoff : {10.0f, 40.0f, 75.0f, 88.0f}) {
      SCOPED_TRACE(cutoff);
      expectSeen(scene, spotAt(position, position + random.direction(), cutoff), random);
    }
    expectSeen(scene, spotAt(position, glm::vec3(0), 30.0f), random);
    expectSeen(scene, omniAt(position), random);
    expectSeen(scene, sunAlong(random.direction()), random);
    expectSeen(scene, sunAlong({0, -1, 0}), random);
  }
}

/// Corners of the body around spheres see them all, and little more than their box.
TEST(Focus, BodiesAroundSpheresHoldThem) {
  Random random(9);
  for (int i = 0; i < 60; ++i) {
    Scene scene = reference::emptyScene();
    reference::SphereParts data;
    for (int k = 0; k <= i; ++k) {
      data.centers.push_back(float(random.uniform(0.0, 2.0)) * random.direction());
      data.radii.push_back(float(random.uniform(0.01, 0.5)));
    }
    const glm::mat4 pose = scene::composeTransform(random.direction(), random.direction(), 50.0f,
                                                   glm::vec3(float(random.uniform(0.1, 5.0))));
    reference::addSpheres(scene, data, reference::addMaterial(scene, glm::vec3(1), 1.0f), pose);
    const std::vector<glm::dvec3> hull = hullPoints(scene, shapesOf(scene).front());
    for (int turn = 0; turn < 100; ++turn) {
      const glm::dvec3 way(random.direction());
      double spheres = -INFINITY, corners = -INFINITY;
      for (std::size_t k = 0; k < data.centers.size(); ++k)
        spheres = std::max(spheres, glm::dot(way, glm::dvec3(pose * glm::vec4(data.centers[k], 1.0f))) +
                                        scene::scaleOf(pose) * data.radii[k]);
      for (const glm::dvec3& p : hull) corners = std::max(corners, glm::dot(way, p));
      EXPECT_GE(corners, spheres - 1e-5 * scene::scaleOf(pose));
      EXPECT_LE(corners, spheres + 0.9 * scene::scaleOf(pose));
    }
  }
}

/// Objects on both ends of a very wide cone.
TEST(Focus, SeesBothEndsOfAWideCone) {
  Random random(2);
  for (const float angle : {50.0f, 60.0f, 70.0f, 80.0f, 85.0f}) {
    Scene scene = reference::emptyScene();
    for (const float side : {-45.0f, angle}) {
      const float radians = glm::radians(side);
      addCube(scene, {4.0f * std::sin(radians), -4.0f * std::cos(radians), 0.0f}, 0.05f);
    }
    SCOPED_TRACE(angle);
    expectSeen(scene, spotAt(glm::vec3(0), {0, -1, 0}, 88.0f), random);
  }
}

TEST(Focus, SeesWhatIsAroundTheLight) {
  Random random(3);
  for (const LightType type : {LightType::Spot, LightType::Omni}) {
    Scene around = reference::emptyScene();
    Light light = spotAt({0.1f, 0.2f, -0.1f}, {1, 0.5f, 0.2f}, 50.0f);
    light.type = type;
    addCube(around, glm::vec3(0), 1.0f);
    expectSeen(around, light, random);
    addCube(around, {0.1f, 0.2f, 1.0f}, 0.3f);
    expectSeen(around, light, random);
    Scene ring = reference::emptyScene();
    for (int i = 0; i < 12; ++i) addCube(ring, 2.0f * random.direction(), 0.1f);
    expectSeen(ring, light, random);
    Scene plane = reference::emptyScene();
    addFloor(plane, 0.0f, 50.0f);
    expectSeen(plane, light, random);
  }
}

TEST(Focus, NeedsOneMapWhereOneIsEnough) {
  Scene scene = reference::emptyScene();
  addCube(scene, {3, 3, 0}, 0.5f);  // across a border between two sides
  const std::vector<Caster> shapes = shapesOf(scene);
  const std::vector<MapView> single = focusedViews(scene, omniAt(glm::vec3(0)), shapes, {0}, kSize);
  ASSERT_EQ(single.size(), 1u);
  EXPECT_EQ(single.front().face, CDSM_FACE_ANY);
  EXPECT_LT(single.front().fovX, 25.0);
  addCube(scene, {-3, 3, 0}, 0.5f);
  addCube(scene, {3, -3, 0}, 0.5f);
  EXPECT_EQ(focusedViews(scene, omniAt(glm::vec3(0)), shapesOf(scene), {0, 1, 2}, kSize).size(), 4u);
  EXPECT_TRUE(focusedViews(scene, spotAt({0, 0, 0}, {0, 0, 1}, 20.0f), shapesOf(scene), {0, 1}, kSize).empty());
}

glm::dvec3 xyz(const shared::float4& v) { return {v.x, v.y, v.z}; }
double areaOf(const shared::ViewData& view) {
  return glm::length(glm::cross(xyz(view.originU), xyz(view.originV))) * kSize * kSize;
}

/// Parallel light: no larger than the rectangle along any other sides, and half of it for a slim box aslant.
TEST(Focus, RectanglesAreTight) {
  Random random(4);
  const double margin = double(kSize) / (kSize - 2) * double(kSize) / (kSize - 2);
  for (int i = 0; i < 100; ++i) {
    Scene scene = reference::emptyScene();
    for (int k = 0; k <= i % 3; ++k) addRandomObject(scene, random, 1.0);
    const Light light = sunAlong(random.direction());
    std::vector<unsigned> objects(scene.meshes.size());
    std::iota(objects.begin(), objects.end(), 0u);
    const std::vector<MapView> maps = focusedViews(scene, light, shapesOf(scene), objects, kSize);
    ASSERT_EQ(maps.size(), 1u);
    const LightFrame frame = lightFrames(light).front();
    for (int turn = 0; turn < 18; ++turn) {
      const double angle = glm::radians(5.0 * turn);
      const glm::dvec3 u = std::cos(angle) * frame.right + std::sin(angle) * frame.down, v = glm::cross(frame.axis, u);
      glm::dvec2 low(INFINITY), high(-INFINITY);
      for (const unsigned object : objects)
        for (const glm::dvec3& p : hullPoints(scene, shapesOf(scene)[object])) {
          low = glm::min(low, glm::dvec2(glm::dot(u, p), glm::dot(v, p)));
          high = glm::max(high, glm::dvec2(glm::dot(u, p), glm::dot(v, p)));
        }
      EXPECT_LE(areaOf(maps.front().view), margin * (high.x - low.x) * (high.y - low.y) * 1.001) << i;
    }
  }
}

TEST(Focus, PicturesOfASpotAreNoLargerThanItsCone) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    Scene scene = reference::emptyScene();
    for (int k = 0; k < 2; ++k) addRandomObject(scene, random, 2.0);
    const float cutoff = float(random.uniform(5.0, 60.0));
    const Light light = spotAt(4.0f * random.direction(), glm::vec3(0), cutoff);
    for (const MapView& map : focusedViews(scene, light, shapesOf(scene), {0, 1}, kSize)) {
      EXPECT_LE(map.fovX, 1.06 * mapFov(wholeViews(light, shapesOf(scene), {0, 1}, kSize).front().view)) << cutoff;
      EXPECT_LE(map.fovY, 1.06 * mapFov(wholeViews(light, shapesOf(scene), {0, 1}, kSize).front().view)) << cutoff;
    }
  }
}

/// A cube of one degree far away fills its picture, whatever the cone.
TEST(Focus, PicturesOfSmallObjectsAreNarrow) {
  Scene scene = reference::emptyScene();
  const unsigned cube = addCube(scene, {2, 0.5f, 1}, 0.1f);
  for (const Light& light : {spotAt({0, 12, 0}, glm::vec3(0), 40.0f), omniAt({0, 12, 0})}) {
    const std::vector<MapView> maps = focusedViews(scene, light, shapesOf(scene), {cube}, kSize);
    ASSERT_EQ(maps.size(), 1u);
    EXPECT_LT(std::max(maps.front().fovX, maps.front().fovY), 2.0);
    EXPECT_GT(maps.front().nearDepth, 11.0);
  }
}

}  // namespace
}  // namespace cdsm::cluster
