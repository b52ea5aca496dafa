// SPDX-License-Identifier: Apache-2.0
// Debug pictures: counts against those of slow rays, nodes of visibility functions known by hand, clusters by their
// colours, texels by their number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/debug_colors.hpp"
#include "property/engine_paths.hpp"
#include "property/light_frame.hpp"
#include "reference/reference.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::images {
namespace {

using reference::addMaterial;
using reference::addMesh;
using reference::World;
using Counts = std::vector<std::int64_t>;

const std::vector<property::Path>& paths() {
  static const std::vector<property::Path> list = [] {
    std::vector<property::Path> all;
    for (const property::Path& path : property::allPaths())
      if (path.technique == "deep-shadow-map" && property::canFetch(path.fetch)) all.push_back(path);
    return all;
  }();
  return list;
}

Engine& engineOf(const property::Path& path) { return property::engineOf(path.fetch); }

glm::mat4 moved(float x, float y, float z) {
  glm::mat4 result(1.0f);
  result[3] = {x, y, z, 1.0f};
  return result;
}

Scene smallScene() {
  Scene scene = reference::emptyScene();
  scene.camera.position = {0.53f, 1.71f, 4.37f};
  scene.image.width = 45;
  scene.image.height = 33;
  return scene;
}

/// Two overlapping volumes, one of them cut, a sheet through both, a floor, and a sheet that the floor hides.
Scene countedScene() {
  Scene scene = smallScene();
  const auto full = [](const glm::dvec3&) { return 1.0; };
  addMesh(scene, reference::quadMesh({0, 0.1f, 0}, {1.5f, 0.2f, 0}, {0, 0, 1.5f}),
          addMaterial(scene, glm::vec3(1), 0.3f));
  addMesh(scene, reference::stackMesh(1, -1.0f, 1.0f, 2.5f), addMaterial(scene, glm::vec3(1), 1.0f));
  addMesh(scene, reference::stackMesh(1, -1.5f, 1.0f, 2.0f), addMaterial(scene, glm::vec3(1), 0.5f));
  const int box = addMesh(scene, reference::boxMesh({0.1f, -0.6f, -0.5f}, {1.2f, 0.3f, 0.6f}),
                          addMaterial(scene, glm::vec3(1), 0.0f));
  const VolumeData data =
      reference::makeVolume(VoxelType::UInt8, glm::uvec3(9), glm::vec3(-0.7f), glm::vec3(0.7f), full);
  const TransferFunction faint = reference::constantOpacity(0.2f, 1.0f);
  reference::addVolume(scene, data, faint, moved(-0.31f, 0.07f, 0.03f));
  const int cut = reference::addVolume(scene, data, faint, moved(0.47f, -0.05f, 0.19f));
  scene.volumes[std::size_t(cut)].boundary = box;
  return scene;
}

std::int64_t layersOf(const World& world, const reference::Ray& ray) {
  std::int64_t count = 0;
  for (const reference::Segment& segment : segmentsOf(world, ray, behindAll(world, ray)))
    count += std::int64_t(segment.after.size());
  for (const reference::Grid& grid : world.grids) count += grid.inside(ray).begin < grid.inside(ray).end ? 2 : 0;
  return count;
}

std::int64_t stepsOf(const World& world, const reference::Ray& ray) {
  std::int64_t count = 0;
  for (const reference::Segment& segment : segmentsOf(world, ray, behindAll(world, ray))) {
    if (!segment.volumes.empty()) count += stepsIn(segment, 0.5 * smallestEdge(world, segment));
    for (const reference::Crossing& crossing : segment.after)
      if (reference::materialOf(world, crossing).opacity == 1.0f) return count;
  }
  return count;
}

/// Counts of all pixels; none where they are 0.
Counts countsOf(const World& world, std::int64_t (*countOf)(const World&, const reference::Ray&)) {
  Counts counts;
  for (int y = 0; y < world.scene.image.height; ++y)
    for (int x = 0; x < world.scene.image.width; ++x) {
      const std::int64_t count = countOf(world, reference::cameraRay(world.scene, x + 0.5, y + 0.5));
      counts.push_back(count > 0 ? count : engine::kNothing);
    }
  return counts;
}

void expectCounts(Engine& engine, const Scene& scene, DebugView view, const Counts& counts) {
  const Image image = engine.render(scene, {view, {}});
  const auto greatest = std::uint64_t(*std::max_element(counts.begin(), counts.end()));
  ASSERT_EQ(engine.stats().view->scale, greatest);
  ASSERT_EQ(image.pixels.size(), counts.size());
  const std::vector<shared::float4> expected = engine::countColors(counts, greatest);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    wrong += image.pixels[i] != glm::vec4(expected[i].x, expected[i].y, expected[i].z, expected[i].w);
  EXPECT_EQ(wrong, 0u) << "of " << counts.size() << " pixels";
}

TEST(DebugView, layersAndStepsAreThoseOfSlowRays) {
  Scene scene = countedScene();
  scene.image.background = glm::vec3(0.5f);
  const World world(scene);
  const Counts layers = countsOf(world, layersOf), steps = countsOf(world, stepsOf);
  ASSERT_GE(*std::max_element(layers.begin(), layers.end()), 9);
  ASSERT_EQ(std::count(layers.begin(), layers.end(), engine::kNothing) > 0, true);
  for (const char* technique : {"none", "shadow-rays", "deep-shadow-map"}) {
    for (const char* fetch : {"buffer", "image"}) {
      if (!property::canFetch(fetch)) continue;
      SCOPED_TRACE(technique + std::string(fetch));
      scene.shadows.technique = technique;
      expectCounts(property::engineOf(fetch), scene, DebugView::Layers, layers);
      expectCounts(property::engineOf(fetch), scene, DebugView::Steps, steps);
    }
  }
}

constexpr float kSheetY = 0.0f, kSheetHalf = 0.6f, kFloorY = -1.0f;

/// A translucent sheet over a floor.
Scene sheetScene(LightType type) {
  Scene scene = smallScene();
  addMesh(scene, reference::stackMesh(1, kFloorY, 1.0f, 2.5f), addMaterial(scene, glm::vec3(0.7f), 1.0f));
  addMesh(scene, reference::quadMesh({0, kSheetY, 0}, {kSheetHalf, 0, 0}, {0, 0, kSheetHalf}),
          addMaterial(scene, glm::vec3(0.7f), 0.5f));
  scene.lights.front().type = type;
  scene.lights.front().direction = {0.3f, -1.0f, 0.2f};
  scene.lights.front().cutoff = 20.0f;
  return scene;
}

/// The floor is one node; a sheet in front is one, and the depth just before the floor another. -2: too near to an edge
/// to tell.
std::int64_t nodesByHand(const Scene& scene, const reference::Ray& ray) {
  constexpr double kMargin = 0.08;
  const auto at = [&](double y) { return ray.at((y - ray.origin.y) / ray.direction.y); };
  const auto beyondSheet = [](const glm::dvec3& p) {
    return std::max(std::abs(p.x), std::abs(p.z)) - double(kSheetHalf);
  };
  const double beyondFloor = std::max(std::abs(at(kFloorY).x), std::abs(at(kFloorY).z)) - 2.5;
  const double ofPixel = beyondSheet(at(kSheetY));
  if (ray.direction.y >= 0.0 || (beyondFloor > 0.0 && ofPixel > kMargin)) return engine::kNothing;
  const glm::dvec3 seen = at(ofPixel < 0.0 ? kSheetY : kFloorY);
  const glm::dvec3 way = reference::towardsLight(scene.lights.front(), seen);
  const double shadow = beyondSheet(seen + way * ((double(kSheetY) - seen.y) / way.y));
  const double fromCone = std::tan(glm::radians(20.0)) * (4.0 - seen.y) - std::hypot(seen.x, seen.z);
  const bool spot = scene.lights.front().type == LightType::Spot;
  if (std::abs(beyondFloor) < kMargin || std::abs(ofPixel) < kMargin || std::abs(shadow) < kMargin ||
      (spot && std::abs(fromCone) < kMargin))
    return -2;
  return spot && fromCone < 0.0 ? 0 : shadow < 0.0 ? 3 : 1;
}

TEST(DebugView, nodesAreThoseOfTheTexelOfWhatIsSeen) {
  for (const property::Path& path : paths()) {
    if (path.memory == "tiled") continue;  // repeats the last node up to a whole block
    for (const LightType type : {LightType::Spot, LightType::Omni, LightType::Directional}) {
      SCOPED_TRACE(path.name() + ", type of light " + std::to_string(int(type)));
      const Scene scene = property::along(path, sheetScene(type), 128, 0.01f);
      const Image image = engineOf(path).render(scene, {DebugView::Nodes, "key"});
      ASSERT_EQ(engineOf(path).stats().view->scale, 3u);
      std::size_t wrong = 0, sure[2] = {0, 0};
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto x = double(i % 45), y = double(i / 45);
        const std::int64_t nodes = nodesByHand(scene, reference::cameraRay(scene, x + 0.5, y + 0.5));
        if (nodes == -2) continue;
        const glm::vec3 expected =
            nodes == engine::kNothing ? glm::vec3(0.0f) : engine::scaleColor(float(nodes) / 3.0f);
        wrong += glm::vec3(image.pixels[i]) != expected;
        if (nodes > 0) ++sure[nodes / 2];
      }
      EXPECT_EQ(wrong, 0u);
      EXPECT_GE(std::min(sure[0], sure[1]), 30u);
    }
  }
}

TEST(DebugView, nodesOfSeveralMapsAreAdded) {
  Scene scene = property::along(property::mapPath(), sheetScene(LightType::Spot), 64, 0.01f);
  scene.meshes.front().shadow.casts = false;
  addMesh(scene, reference::quadMesh({0.7f, 1.0f, 0}, {kSheetHalf, 0, 0}, {0, 0, kSheetHalf}),
          scene.meshes[1].material);
  scene.shadows.clusters = 2;
  scene.shadows.clusterDistance = 0.001f;
  Engine& engine = property::engineOf("buffer");
  engine.render(scene, {DebugView::Nodes, {}});
  ASSERT_EQ(engine.stats().lights.front().maps.size(), 2u);
  EXPECT_EQ(engine.stats().view->scale, 2u) << "where both sheets are in the light's way";
}

/// Two balls far apart over a floor that casts no shadow.
Scene ballsScene() {
  Scene scene = smallScene();
  const int material = addMaterial(scene, {0.2f, 0.5f, 0.9f}, 1.0f);
  scene.materials.front().specular = glm::vec3(0.5f);
  addMesh(scene, reference::stackMesh(1, kFloorY, 1.0f, 2.5f), material);
  scene.meshes.front().shadow.casts = false;
  addMesh(scene, reference::sphereMesh(0.4f, 16, 8, true), material, moved(-1.1f, -0.5f, 0.0f));
  addMesh(scene, reference::sphereMesh(0.4f, 16, 8, true), material, moved(1.2f, -0.5f, 0.2f));
  reference::addVolume(scene,
                       reference::makeVolume(VoxelType::UInt8, glm::uvec3(8), glm::vec3(-0.3f), glm::vec3(0.3f),
                                             [](const glm::dvec3&) { return 1.0; }),
                       reference::constantOpacity(0.999f, 0.05f), moved(-1.1f, 0.4f, 0.0f));
  scene.meshes[0].name = "floor";
  scene.meshes[1].name = "left";
  scene.meshes[2].name = "right";
  scene.volumes[0].name = "cloud";
  scene.lights.front().cutoff = 40.0f;
  return scene;
}

/// Number of the cluster whose map holds the object, of the frame's first light.
unsigned clusterOf(const FrameStats& stats, const std::string& object) {
  for (const MapStats& map : stats.lights.front().maps)
    if (std::count(map.objects.begin(), map.objects.end(), object) > 0) return unsigned(map.cluster);
  ADD_FAILURE() << object << " is in no map";
  return 0;
}

bool anyRegenerated(const FrameStats& stats) {
  const std::vector<MapStats>& maps = stats.lights.front().maps;
  return std::any_of(maps.begin(), maps.end(), [](const MapStats& map) { return map.regenerated; });
}

/// The hue of the pixel in which a world point is seen.
void expectHue(const Scene& scene, const Image& image, const glm::vec3& point, const glm::vec3& hue) {
  double nearest = 1e9;
  glm::vec3 color;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const reference::Ray ray = reference::cameraRay(scene, double(i % 45) + 0.5, double(i / 45) + 0.5);
    const double beside = glm::length(glm::cross(glm::dvec3(point) - ray.origin, ray.direction));
    if (beside < nearest) color = glm::vec3(image.pixels[i]);
    nearest = std::min(nearest, beside);
  }
  EXPECT_GT(glm::length(color), 0.01f);
  EXPECT_NEAR(glm::length(glm::normalize(color) - glm::normalize(hue)), 0.0f, 1e-3f);
}

TEST(DebugView, clustersAreColouredAndMapsAreKept) {
  for (const property::Path& path : paths()) {
    SCOPED_TRACE(path.name());
    Scene scene = property::along(path, ballsScene(), 64, 0.01f);
    scene.shadows.clusters = 2;
    Engine& engine = engineOf(path);
    const Image before = engine.render(scene);
    const Image image = engine.render(scene, {DebugView::Clusters, {}});
    EXPECT_FALSE(anyRegenerated(engine.stats()));
    const unsigned left = clusterOf(engine.stats(), "left"), right = clusterOf(engine.stats(), "right");
    ASSERT_NE(left, right);
    expectHue(scene, image, {-1.1f, -0.4f, 0.2f}, engine::clusterColor(left));
    expectHue(scene, image, {1.2f, -0.4f, 0.4f}, engine::clusterColor(right));
    expectHue(scene, image, {-1.1f, 0.4f, 0.0f}, engine::clusterColor(clusterOf(engine.stats(), "cloud")));
    expectHue(scene, image, {0.1f, kFloorY, 1.0f}, glm::vec3(1.0f));
    const Image after = engine.render(scene);
    EXPECT_FALSE(anyRegenerated(engine.stats()));
    EXPECT_EQ(before.pixels, after.pixels) << "the colours stayed";
  }
}

/// 1 where a world point on the floor is in an even texel of the light's only map, 0 in an odd one, -1 near a border.
int evenTexel(const property::LightFrame& map, int mapSize, const glm::dvec3& point) {
  constexpr double kMargin = 0.3;
  const glm::dvec3 at = map.coordinates(point) / map.texel();
  const glm::dvec2 texel = glm::dvec2(at.x, -at.y) + 0.5 * mapSize, inside = glm::fract(texel);
  if (glm::any(glm::lessThan(inside, glm::dvec2(kMargin))) ||
      glm::any(glm::greaterThan(inside, glm::dvec2(1.0 - kMargin))))
    return -1;
  return (int(std::floor(texel.x)) + int(std::floor(texel.y)) + 2 * mapSize) % 2 == 0;
}

float sum(const glm::vec4& color) { return color.x + color.y + color.z; }

void expectTexels(const property::Path& path, int mapSize) {
  Scene scene = property::along(path, sheetScene(LightType::Spot), mapSize, 0.01f);
  scene.meshes.pop_back();
  scene.image.width = 90;
  scene.image.height = 66;
  const property::LightFrame map(scene, scene.lights.front(), mapSize);
  const Image plain = engineOf(path).render(scene), texels = engineOf(path).render(scene, {DebugView::Texels, {}});
  int counts[2] = {0, 0}, wrong = 0;
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
    const reference::Ray ray = reference::cameraRay(scene, double(i % 90) + 0.5, double(i / 90) + 0.5);
    const glm::dvec3 point = ray.at((double(kFloorY) - ray.origin.y) / ray.direction.y);
    const double beyondCone = std::hypot(point.x, point.z) - std::tan(glm::radians(20.0)) * (4.0 - double(kFloorY));
    if (ray.direction.y >= 0.0 || beyondCone > 0.01) {
      EXPECT_EQ(plain.pixels[i], texels.pixels[i]) << "nothing is looked up at pixel " << i;
      continue;
    }
    const int even = evenTexel(map, mapSize, point);
    if (even < 0 || beyondCone > -0.05) continue;
    ++counts[even];
    wrong += std::abs(sum(texels.pixels[i]) / sum(plain.pixels[i]) - (even ? 1.0f : 0.45f)) > 0.02f;
  }
  EXPECT_EQ(wrong, 0) << "of " << counts[0] << " in odd texels and " << counts[1] << " in even ones";
  EXPECT_GE(std::min(counts[0], counts[1]), 40);
}

TEST(DebugView, texelsAreThoseOfTheMap) {
  for (const int mapSize : {8, 11}) {
    SCOPED_TRACE("map size " + std::to_string(mapSize));
    expectTexels(property::mapPath("chunked", "nearest"), mapSize);
    expectTexels(property::mapPath("atlas"), mapSize);
  }
}

TEST(DebugView, needsMapsToShow) {
  Engine& engine = property::engineOf("buffer");
  Scene scene = sheetScene(LightType::Spot);
  EXPECT_THROW(engine.render(scene, {DebugView::Layers, "fill"}), Error);
  scene.shadows.technique = "none";
  for (const DebugView view : {DebugView::Clusters, DebugView::Nodes, DebugView::Texels})
    EXPECT_THROW(engine.render(scene, {view, {}}), Error);
  scene.shadows.technique = "deep-shadow-map";
  scene.lights.clear();
  EXPECT_THROW(engine.render(scene, {DebugView::Nodes, {}}), Error);
  EXPECT_NO_THROW(engine.render(scene, {DebugView::Steps, {}}));
}

}  // namespace
}  // namespace cdsm::images
