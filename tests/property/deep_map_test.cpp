// SPDX-License-Identifier: Apache-2.0
// Exported maps: what a deep EXR file says, read by another library, is what the query service answers.
#include <gtest/gtest.h>

#include <cstdlib>

#include "deep_map_file.hpp"
#include "engine_paths.hpp"
#include "io/map_file.hpp"
#include "reference/test_scenes.hpp"
#include "unit/io_test_files.hpp"

namespace cdsm::property {
namespace {

constexpr int kMapSize = 72;  // no multiple of a tile's 64
constexpr float kTolerance = 0.01f;
constexpr double kNodeDistance = 2e-4;  // nearer to a surface, rounding decides on which side a point is

struct ExportCase {
  std::string name;
  int clusters;
  Light light;
};

std::vector<ExportCase> exportCases() {
  const std::vector<Light> others = reference::otherLights(3);
  return {{"Spot", 1, reference::randomScene(3).lights[0]},
          {"ClusteredSpot", 3, reference::randomScene(3).lights[0]},
          {"Omni", 1, others[0]},
          {"ClusteredDirectional", 3, others[1]}};
}

Scene sceneOf(const ExportCase& exported, const Path& path) {
  Scene scene = reference::randomScene(3);
  scene.lights.push_back(exported.light);  // not the first light: its maps are behind those of another
  scene.lights.back().name = "exported";
  scene.shadows.clusters = exported.clusters;
  return along(path, scene, kMapSize, kTolerance);
}

std::vector<LightMap> exportTo(const std::string& path, const Scene& scene, const std::string& fetch,
                               io::MapFileLayout layout) {
  std::vector<LightMap> maps = engineOf(fetch).lightMaps(scene, "exported");
  io::writeLightMaps(path, scene.lights.back(), maps, layout);
  return maps;
}

std::string sideOf(const glm::dvec3& way) {
  const glm::dvec3 size = glm::abs(way);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return std::string(way[axis] < 0.0 ? "-" : "+") + "xyz"[axis];
}

/// What the parts say of a point; negative if it lies where rounding decides.
double fromFile(const std::vector<DeepPart>& parts, const Light& light, const glm::dvec3& point) {
  double t = 1.0;
  for (const DeepPart& part : parts) {
    if (!part.side.empty() && part.side != sideOf(point - glm::dvec3(light.position))) continue;
    double offCentre = 0.0;
    const int texel = part.texelOf(point, offCentre);
    if (offCentre > 0.49) return -1.0;
    if (texel < 0) continue;
    const double depth = part.depthOf(point);
    for (const DeepSample& sample : part.texels[std::size_t(texel)])
      if (std::min(std::abs(depth - double(sample.z)), std::abs(depth - double(sample.zBack))) < kNodeDistance)
        return -1.0;
    t *= part.transmittance(texel, depth);
  }
  return t;
}

/// Points on rays of texel centres of all parts, some in front of and some behind what casts.
std::vector<glm::vec3> pointsOnRays(const std::vector<DeepPart>& parts) {
  reference::Random random(12);
  std::vector<glm::vec3> points;
  for (const DeepPart& part : parts)
    for (int i = 0; i < 1500; ++i) {
      const int x = random.integer(1, part.width - 2), y = random.integer(1, part.height - 2);
      const std::vector<DeepSample>& texel = part.texels[std::size_t(y * part.width + x)];
      const double first = texel.empty() ? 0.5 : 0.9 * double(texel.front().z);
      const double last = texel.empty() ? 4.0 : 1.1 * double(texel.back().zBack);
      points.emplace_back(part.worldPoint(x, y, random.uniform(first, last)));
    }
  return points;
}

class ExportedMaps : public ::testing::TestWithParam<std::tuple<Path, ExportCase, io::MapFileLayout>> {};

TEST_P(ExportedMaps, sayWhatTheQueryServiceAnswers) {
  const auto& [path, exported, layout] = GetParam();
  if (!canFetch(path.fetch)) GTEST_SKIP() << "the device has no images";
  const Scene scene = sceneOf(exported, path);
  const test::TemporaryFolder folder;
  const std::string file = folder.path("deep.exr");
  const std::vector<LightMap> maps = exportTo(file, scene, path.fetch, layout);
  const std::vector<DeepPart> parts = readDeepParts(file);
  ASSERT_EQ(parts.size(), maps.size());
  for (const DeepPart& part : parts) EXPECT_EQ(part.tileWidth, layout == io::MapFileLayout::Tiles ? 64 : 0);
  const std::vector<glm::vec3> points = pointsOnRays(parts);
  const std::vector<Transmittance> answers = query(path, scene, points, "exported");
  int compared = 0, shadowed = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = answers[i].lit ? fromFile(parts, scene.lights.back(), glm::dvec3(points[i])) : -1.0;
    if (t < 0.0) continue;
    ++compared;
    shadowed += t < 0.99;
    ASSERT_NEAR(answers[i].transmittance, t, 5e-4) << glm::distance(points[i], scene.lights.back().position);
  }
  EXPECT_GT(compared, int(points.size()) / 2);
  EXPECT_GT(shadowed, compared / 20);
}

std::vector<Path> nearestPaths() {
  std::vector<Path> paths;
  for (const Path& path : allPaths())
    if (path.technique == "deep-shadow-map" && path.filter == "nearest") paths.push_back(path);
  return paths;
}

INSTANTIATE_TEST_SUITE_P(All, ExportedMaps,
                         ::testing::Combine(::testing::ValuesIn(nearestPaths()), ::testing::ValuesIn(exportCases()),
                                            ::testing::Values(io::MapFileLayout::Scanlines, io::MapFileLayout::Tiles)),
                         [](const auto& info) {
                           const bool tiles = std::get<2>(info.param) == io::MapFileLayout::Tiles;
                           return std::get<0>(info.param).name() + std::get<1>(info.param).name +
                                  (tiles ? "Tiles" : "Scanlines");
                         });

TEST(LightMaps, lieInTheOrderThatTheyPromise) {
  for (const ExportCase& exported : exportCases()) {
    const Scene scene = sceneOf(exported, mapPath());
    for (const LightMap& map : engineOf("buffer").lightMaps(scene, "exported")) {
      ASSERT_EQ(map.firstNode.size(), std::size_t(map.width * map.height) + 1);
      ASSERT_EQ(map.firstNode.front(), 0u);
      ASSERT_EQ(map.firstNode.back(), map.nodes.size());
      for (std::size_t texel = 0; texel + 1 < map.firstNode.size(); ++texel)
        for (std::uint32_t i = map.firstNode[texel] + 1; i < map.firstNode[texel + 1]; ++i) {
          ASSERT_GE(map.nodes[i].depth, map.nodes[i - 1].depth);
          ASSERT_LE(map.nodes[i].transmittance, map.nodes[i - 1].transmittance);
        }
    }
    const std::vector<MapStats>& stats = engineOf("buffer").stats().lights.back().maps;
    EXPECT_EQ(engineOf("buffer").lightMaps(scene, "exported").size(), stats.size());
  }
}

TEST(LightMaps, areOfTheTechniqueThatHasThem) {
  Scene scene = sceneOf(exportCases()[0], rayPath());
  EXPECT_THROW(engineOf("buffer").lightMaps(scene, "exported"), Error);
  scene.shadows.technique = "deep-shadow-map";
  EXPECT_THROW(engineOf("buffer").lightMaps(scene, "no light"), Error);
  EXPECT_FALSE(engineOf("buffer").lightMaps(scene, "exported").empty());
}

TEST(LightMaps, areWrittenWholeOrNotAtAll) {
  const Scene scene = sceneOf(exportCases()[0], mapPath());
  const Light& light = scene.lights.back();
  const std::vector<LightMap> maps = engineOf("buffer").lightMaps(scene, "exported");
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::vector<LightMap>& some) {
    io::writeLightMaps(folder.path(name), light, some, io::MapFileLayout::Scanlines);
  };
  EXPECT_THROW(write("map.png", maps), Error);
  EXPECT_THROW(write("map.exr", {}), Error);
  EXPECT_THROW(write("none/map.exr", maps), Error);
  EXPECT_EQ(folder.files(), 0u);
  write("map.exr", maps);
  write("again.exr", engineOf("buffer").lightMaps(scene, "exported"));
  EXPECT_EQ(test::readBytes(folder.path("map.exr")), test::readBytes(folder.path("again.exr")));
  EXPECT_EQ(folder.files(), 2u);
}

TEST(DeepMaps, areWholeForOpenExrsOwnTools) {
  if (std::system("command -v exrinfo > /dev/null") != 0) GTEST_SKIP() << "exrinfo is not installed";
  for (const auto layout : {io::MapFileLayout::Scanlines, io::MapFileLayout::Tiles}) {
    const test::TemporaryFolder folder;
    const std::string deep = folder.path("deep.exr"), info = folder.path("info.txt");
    const auto maps = exportTo(deep, sceneOf(exportCases()[2], mapPath()), "buffer", layout);
    ASSERT_EQ(std::system(("exrinfo -v -s " + deep + " > " + info).c_str()), 0);
    const std::string text = test::readBytes(info);
    const std::string type = layout == io::MapFileLayout::Tiles ? "deeptile" : "deepscanline";
    for (std::size_t part = 0; part < maps.size(); ++part)
      EXPECT_NE(text.find("exported.cluster0.map" + std::to_string(part)), std::string::npos) << text;
    for (const std::string& word : {type, std::string("worldToNDC: m44f"), std::string("worldToCamera: m44f")})
      EXPECT_NE(text.find(word), std::string::npos) << text;
  }
}

TEST(DeepMaps, flattenToTheTransmittanceBehindThem) {
  if (std::system("command -v oiiotool > /dev/null") != 0) GTEST_SKIP() << "oiiotool is not installed";
  for (const auto layout : {io::MapFileLayout::Scanlines, io::MapFileLayout::Tiles}) {
    const test::TemporaryFolder folder;
    const std::string deep = folder.path("deep.exr"), flat = folder.path("flat.exr");
    const auto maps = exportTo(deep, sceneOf(exportCases()[3], mapPath()), "buffer", layout);
    ASSERT_EQ(std::system(("oiiotool --info -v " + deep + " > /dev/null").c_str()), 0);
    const std::string command = "oiiotool " + deep + " -a --flatten -o " + flat;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const auto alphas = readFlatAlphas(flat);
    ASSERT_EQ(alphas.size(), maps.size());
    for (std::size_t part = 0; part < maps.size(); ++part)
      for (std::size_t texel = 0; texel < alphas[part].size(); ++texel) {
        const std::uint32_t end = maps[part].firstNode[texel + 1];
        const bool empty = end == maps[part].firstNode[texel];
        ASSERT_NEAR(alphas[part][texel], empty ? 0.0f : 1.0f - maps[part].nodes[end - 1].transmittance, 2e-6f);
      }
  }
}

}  // namespace
}  // namespace cdsm::property
