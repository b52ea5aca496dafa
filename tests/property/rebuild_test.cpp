// SPDX-License-Identifier: Apache-2.0
// Which maps are built again after a change, and why; that kept maps are those that a new engine would build.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "engine_paths.hpp"
#include "frames.hpp"
#include "reference/test_scenes.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 32;
constexpr float kTolerance = 0.01f;

using Change = std::function<void(Scene&)>;
using Reasons = std::multiset<std::string>;  ///< of the maps that were built; empty: all were kept

/// The row in the light of a spot, an omni light and a directional one.
Scene litRow(int clusters) {
  Scene scene = along(mapPath("chunked", "bilinear", clusters), rowScene(), kMapSize, kTolerance);
  Light omni = scene.lights.front(), sun = omni;
  omni.name = "lamp";
  omni.type = LightType::Omni;
  omni.position = {0.2f, 1.6f, 0.3f};
  sun.name = "sun";
  sun.type = LightType::Directional;
  sun.direction = {0.3f, -1.0f, 0.2f};
  scene.lights.push_back(omni);
  scene.lights.push_back(sun);
  return scene;
}

Reasons reasonsOf(const LightStats& light) {
  Reasons reasons;
  for (const MapStats& map : light.maps) {
    EXPECT_EQ(map.regenerated, !map.reason.empty());
    if (map.regenerated) reasons.insert(map.reason);
  }
  return reasons;
}

Reasons reasonsOf(const FrameStats& stats) {
  Reasons all;
  for (const LightStats& light : stats.lights) all.merge(reasonsOf(light));
  return all;
}

bool launched(const FrameStats& stats, const std::string& part) {
  return std::any_of(stats.kernels.begin(), stats.kernels.end(),
                     [&](const KernelTime& kernel) { return kernel.name.find(part) != std::string::npos; });
}

std::size_t mapsOf(const FrameStats& stats) {
  std::size_t count = 0;
  for (const LightStats& light : stats.lights) count += light.maps.size();
  return count;
}

/// An engine that has rendered a scene, and renders it after a change.
class Rebuilding : public ::testing::TestWithParam<int> {
 protected:
  Engine engine_;
  Scene scene_ = litRow(GetParam());

  void SetUp() override { engine_.render(scene_); }
  const FrameStats& after(const Change& change) {
    change(scene_);
    engine_.render(scene_);
    return engine_.stats();
  }
  void expectKept(const std::string& what, const Change& change) {
    EXPECT_EQ(reasonsOf(after(change)), Reasons{}) << what;
    EXPECT_FALSE(launched(engine_.stats(), "visibility")) << what;
  }
  /// All maps of all lights, for that reason.
  void expectAll(const std::string& reason, const Change& change) {
    const Reasons reasons = reasonsOf(after(change));
    EXPECT_EQ(reasons.size(), mapsOf(engine_.stats())) << reason;
    EXPECT_EQ(reasons.count(reason), reasons.size()) << reason << ", found " << *reasons.begin();
  }
  /// All maps of one light for that reason, none of the others.
  void expectLight(std::size_t light, const std::string& reason, const Change& change) {
    const FrameStats& stats = after(change);
    for (std::size_t i = 0; i < stats.lights.size(); ++i) {
      const Reasons reasons = reasonsOf(stats.lights[i]);
      EXPECT_EQ(reasons.size(), i == light ? stats.lights[i].maps.size() : 0u) << reason << ", light " << i;
      EXPECT_EQ(reasons.count(reason), reasons.size()) << reason;
    }
  }
  /// Maps in which an object casts, for that reason; others for none.
  void expectMapsOf(const std::string& object, const std::string& reason, const Change& change) {
    int count = 0;
    for (const LightStats& light : after(change).lights)
      for (const MapStats& map : light.maps) {
        const bool casts = std::count(map.objects.begin(), map.objects.end(), object) > 0;
        EXPECT_EQ(map.reason, casts ? reason : "") << light.name;
        count += casts;
      }
    EXPECT_GE(count, 3) << reason;
  }
};

TEST_P(Rebuilding, FirstAndThenKept) {
  const Reasons first = reasonsOf(engine_.stats());
  EXPECT_EQ(first.size(), mapsOf(engine_.stats()));
  EXPECT_EQ(first.count("first"), first.size());
  EXPECT_GE(first.size(), 8u);
  expectKept("nothing", [](Scene&) {});
}

TEST_P(Rebuilding, NotForWhatIsNotInTheMaps) {
  expectKept("image size", [](Scene& s) { s.image.width = 21, s.image.height = 14; });
  expectKept("ambient", [](Scene& s) { s.image.ambient = glm::vec3(0.3f); });
  expectKept("background", [](Scene& s) { s.image.background = glm::vec3(0.3f); });
  expectKept("supersampling", [](Scene& s) { s.image.supersampling = 2; });
  expectKept("filter", [](Scene& s) { s.shadows.filter = "nearest"; });
  expectKept("bias", [](Scene& s) { s.shadows.bias = 0.01f; });
  expectKept("light's colour", [](Scene& s) { s.lights[0].color = {1, 0.5f, 0}; });
  expectKept("diffuse colour", [](Scene& s) { s.materials[0].diffuse = {1, 0, 0}; });
  expectKept("specular colour", [](Scene& s) { s.materials[0].specular = {1, 0, 0}, s.materials[0].shininess = 9; });
  expectKept("colours of a volume", [](Scene& s) { s.volumes[0].transfer.color[0].color = {1, 0, 0}; });
  expectKept("a volume's shading", [](Scene& s) { s.volumes[0].shading = false; });
  expectKept("receiving", [](Scene& s) { s.meshes[0].shadow.receives = false; });
  expectKept("a spot's direction does not matter", [](Scene& s) { s.lights[0].direction = {1, 2, 3}; });
  expectKept("an omni light's target and cone do not matter",
             [](Scene& s) { s.lights[1].target.x = 3, s.lights[1].cutoff = 9; });
}

TEST_P(Rebuilding, AllForSettings) {
  expectAll("settings", [](Scene& s) { s.shadows.mapSize = 24; });
  expectAll("settings", [](Scene& s) { s.shadows.tolerance = 0.02f; });
  expectAll("settings", [](Scene& s) { s.shadows.step = 0.05f; });
  after([](Scene& s) { s.shadows.memory = "atlas"; });
  const Reasons reasons = reasonsOf(engine_.stats());
  EXPECT_EQ(reasons.size(), mapsOf(engine_.stats()));
  expectKept("the same settings", [](Scene&) {});
}

TEST_P(Rebuilding, OfALight) {
  expectLight(0, "light moved", [](Scene& s) { s.lights[0].position.x += 0.01f; });
  expectLight(0, "light turned", [](Scene& s) { s.lights[0].target.x += 0.01f; });
  expectLight(0, "cone", [](Scene& s) { s.lights[0].cutoff += 0.5f; });
  expectLight(1, "light moved", [](Scene& s) { s.lights[1].position.y += 0.01f; });
  expectLight(2, "light turned", [](Scene& s) { s.lights[2].direction.x += 0.01f; });
  expectLight(2, "light", [](Scene& s) { s.lights[2].name = "moon"; });
  expectKept("light's position where it has none", [](Scene& s) { s.lights[2].position.x += 1.0f; });
}

TEST_P(Rebuilding, OfAnObject) {
  const auto move = [](Scene& s) { s.meshes[1].worldFromObject[3].y += 1e-4f; };
  expectMapsOf("mesh1", "object mesh1", move);
  expectMapsOf("volume0", "transfer function of volume0",
               [](Scene& s) { s.volumes[0].transfer.opacity[1].opacity = 0.8f; });
  expectMapsOf("volume0", "transfer function of volume0", [](Scene& s) { s.volumes[0].transfer.unitDistance = 0.21f; });
  expectMapsOf("volume0", "object volume0", [](Scene& s) { s.volumes[0].worldFromObject[3].y += 1e-4f; });
  expectKept("nothing", [](Scene&) {});
}

TEST_P(Rebuilding, OfAnObjectsOpacity) {
  scene_.materials.push_back(scene_.materials[1]);
  scene_.meshes[3].material = int(scene_.materials.size()) - 1;
  expectKept("another material of the same opacity", [](Scene&) {});
  expectMapsOf("mesh3", "object mesh3", [](Scene& s) { s.materials.back().opacity = 0.4f; });
}

TEST_P(Rebuilding, UploadsNothingTwice) {
  EXPECT_TRUE(launched(engine_.stats(), "upload vertex positions") && launched(engine_.stats(), "macrocell bounds"));
  for (const Change& change : std::vector<Change>{
           [](Scene&) {}, [](Scene& s) { s.meshes[1].worldFromObject[3].x += 0.1f; },
           [](Scene& s) { s.volumes[0].transfer.opacity[1].opacity = 0.7f; },
           [](Scene& s) { s.lights[0].position.x += 0.1f; }, [](Scene& s) { s.camera.position.x += 0.1f; }}) {
    const FrameStats& stats = after(change);
    EXPECT_FALSE(launched(stats, "macrocell bounds"));
    for (const char* what : {"vertex positions", "vertex normals", "triangles", "voxels"})
      EXPECT_FALSE(launched(stats, std::string("upload ") + what)) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Clusters, Rebuilding, ::testing::Values(1, 4));

TEST(Rebuild, OncePerCameraPathWithoutClusters) {
  Scene scene = litRow(1);
  Engine engine;
  for (int frame = 0; frame < 60; ++frame) {
    const float angle = 0.1f * float(frame);
    scene.camera.position = {7.0f * std::sin(angle), 3.0f, 7.0f * std::cos(angle)};
    engine.render(scene);
    EXPECT_EQ(reasonsOf(engine.stats()).empty(), frame > 0) << frame;
  }
}

/// A camera path with clusters: maps of clusters that were not there before are built, no others.
TEST(Rebuild, OfOtherClustersAloneAlongACameraPath) {
  Scene scene = litRow(4);
  scene.lights.resize(1);
  Engine engine;
  int built = 0, kept = 0;
  std::set<std::vector<std::string>> before;
  for (int frame = 0; frame < 40; ++frame) {
    const float angle = 0.15f * float(frame);
    scene.camera.position = {7.0f * std::sin(angle), 3.0f, 7.0f * std::cos(angle)};
    engine.render(scene);
    std::set<std::vector<std::string>> now;
    for (const MapStats& map : engine.stats().lights[0].maps) {
      now.insert(map.objects);
      if (frame == 0) continue;
      EXPECT_EQ(map.reason, before.count(map.objects) > 0 ? "" : "cluster") << frame;
      ++(map.regenerated ? built : kept);
    }
    before = now;
  }
  EXPECT_GT(built, 0);
  EXPECT_GT(kept, built);
}

TEST(Rebuild, OfOneClusterWhenOneObjectMoves) {
  Scene scene = litRow(4);
  Engine engine;
  engine.render(scene);
  scene.meshes[0].worldFromObject[3].y += 1e-4f;
  engine.render(scene);
  for (const LightStats& light : engine.stats().lights) {
    EXPECT_GE(reasonsOf(light).size(), 1u) << light.name;
    EXPECT_LT(reasonsOf(light).size(), light.maps.size()) << light.name;
  }
}

const std::vector<glm::vec3> kPoints{{-2, -0.5f, 0.8f},   {0.1f, -0.5f, 0},      {1.6f, -0.4f, -0.8f},
                                     {0.3f, 0.4f, 0.1f},  {-0.8f, -0.5f, -0.8f}, {5, 1, 3},
                                     {0.1f, 0.7f, 0.05f}, {0.4f, -0.55f, 0.8f}};

struct Answers {
  Image image;
  std::vector<std::vector<Transmittance>> points;
};

Answers answersOf(Engine& engine, const Scene& scene) {
  Answers answers{engine.render(scene), {}};
  for (const Light& light : scene.lights) answers.points.push_back(engine.transmittance(scene, light.name, kPoints));
  return answers;
}

void expectSame(const Answers& a, const Answers& b, const std::string& what) {
  EXPECT_TRUE(sameBytes(a.image, b.image)) << what;
  for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(largestDifference(a.points[i], b.points[i]), 0.0) << what;
}

class KeptMaps : public ::testing::TestWithParam<std::tuple<std::string, std::string, int>> {
 protected:
  EngineOptions options_;
  Scene scene_;

  void SetUp() override {
    const auto& [memory, fetch, clusters] = GetParam();
    if (!canFetch(fetch)) GTEST_SKIP() << "the device has no images";
    options_.fetch = fetch;
    scene_ = litRow(clusters);
    scene_.shadows.memory = memory;
  }
  void expectAsNew(Engine& engine, const std::string& what) {
    Engine anew(options_);
    expectSame(answersOf(engine, scene_), answersOf(anew, scene_), what);
  }
};

/// Changes of every kind one after another, each leaving other maps in place.
TEST_P(KeptMaps, AnswerAsNewOnes) {
  Engine engine(options_);
  engine.render(scene_);
  const std::vector<std::pair<std::string, Change>> changes{
      {"moved object", [](Scene& s) { s.meshes[2].worldFromObject[3].x += 0.4f; }},
      {"moved light", [](Scene& s) { s.lights[1].position.z -= 0.3f; }},
      {"transfer function", [](Scene& s) { s.volumes[0].transfer.opacity[1].opacity = 0.5f; }},
      {"moved camera",
       [](Scene& s) {
         s.camera.position = {6, 2, 2};
       }},
      {"one light less", [](Scene& s) { s.lights.erase(s.lights.begin()); }},
      {"no shadow of one", [](Scene& s) { s.meshes[0].shadow.casts = false; }},
      {"one object less", [](Scene& s) { s.meshes.erase(s.meshes.begin() + 3); }}};
  for (const auto& [what, change] : changes) {
    change(scene_);
    expectAsNew(engine, what);
  }
}

TEST_P(KeptMaps, StayBetweenPicturesAndQueries) {
  Engine engine(options_);
  const Image first = engine.render(scene_);
  const auto points = engine.transmittance(scene_, "key", kPoints);
  EXPECT_TRUE(sameBytes(engine.render(scene_), first));
  EXPECT_EQ(largestDifference(engine.transmittance(scene_, "key", kPoints), points), 0.0);
  engine.transmittance(scene_, "key", kPoints);
  EXPECT_EQ(reasonsOf(engine.stats()), Reasons{});
}

/// Atlases and pools have to grow with kept maps in them: many more nodes after the first frame.
TEST_P(KeptMaps, StayWhenThereAreManyMoreNodes) {
  Engine engine(options_);
  scene_.volumes[0].transfer.opacity[1].opacity = 0.01f;
  engine.render(scene_);
  scene_.meshes[1].data = std::make_shared<const MeshData>(reference::stackMesh(24, 0.3f, 0.02f, 0.3f));
  scene_.materials[1].opacity = 0.05f;
  expectAsNew(engine, "many layers");
  scene_.meshes[1].data = std::make_shared<const MeshData>(reference::stackMesh(2, 0.3f, 0.02f, 0.3f));
  expectAsNew(engine, "few again");
}

TEST_P(KeptMaps, AreBuiltAnewAfterAFrameThatFailed) {
  Engine engine(options_);
  const Answers before = answersOf(engine, scene_);
  Scene bad = scene_;
  bad.meshes[0].worldFromObject[3].x += 0.5f;
  bad.shadows.step = 1e-9f;  // refused when the scene is on its way to the device
  EXPECT_THROW(engine.render(bad), Error);
  expectSame(answersOf(engine, scene_), before, "after a refused step");
  Scene large = scene_;
  large.shadows.memory = "atlas";
  large.shadows.mapSize = 1 << 15;
  EXPECT_ANY_THROW(engine.render(large));
  expectSame(answersOf(engine, scene_), before, "after maps that do not fit");
}

INSTANTIATE_TEST_SUITE_P(All, KeptMaps,
                         ::testing::Combine(::testing::Values("chunked", "atlas"), ::testing::Values("buffer", "image"),
                                            ::testing::Values(1, 4)),
                         [](const auto& instance) {
                           return std::get<0>(instance.param) + std::get<1>(instance.param) +
                                  std::to_string(std::get<2>(instance.param));
                         });

}  // namespace
}  // namespace cdsm::property
