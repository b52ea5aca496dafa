// SPDX-License-Identifier: Apache-2.0
// Suite "demo": frames with and without shadows, building a map, shadow rays, each against the others.
#include <algorithm>

#include "bench_suites.hpp"
#include "engine/trilinear_rate.hpp"

namespace cdsm::cli {
namespace {

constexpr int kMapSize = 512;

struct BenchScene {
  const char* name;
  const char* file;
  double wantedRaysRatio;
};

constexpr BenchScene kScenes[] = {
    {"demo", "demo/demo.toml", 10.0}, {"smoke", "bench/smoke.toml", 10.0}, {"sparse", "bench/sparse.toml", 4.0}};

/// Times of one scene in milliseconds.
struct Times {
  double none, frame, build, rays;
};

/// One light and the settings that scenes have by default.
Scene sceneOf(const BenchOptions& options, const char* file) {
  Scene scene = readBenchScene(options, file);
  scene.lights.resize(1);
  scene.shadows = ShadowSettings{};
  scene.shadows.mapSize = scaledMapSize(options, kMapSize);
  return scene;
}

/// One frame with shadow rays, which takes too long for medians; kernels are compiled with a tiny image before.
double shadowRaysMs(const BenchOptions& options, Scene scene) {
  scene.shadows.technique = "shadow-rays";
  Subject subject(options, scene);
  subject.scene().image.width = subject.scene().image.height = 8;
  subject.frameMs();
  subject.scene().image = scene.image;
  return subject.frameMs();
}

Times measure(const BenchOptions& options, Subject& maps, const Scene& scene) {
  Scene plain = scene;
  plain.shadows.technique = "none";
  Subject unshadowed(options, plain);
  const auto medians = mediansInTurn(options, {[&] {
                                       const double build = maps.buildMs();
                                       return std::vector<double>{build, maps.frameMs(), unshadowed.frameMs()};
                                     }});
  return {medians[2][0], medians[1][0], medians[0][0], shadowRaysMs(options, scene)};
}

void addColumn(Table& table, const Times& ms, const FrameStats& stats, double rate) {
  const double samples = double(std::max<std::uint64_t>(stats.shadedSamples, 1));
  const double figures[] = {ms.frame / ms.none,
                            ms.frame * rate * 1000.0 / samples,
                            ms.build / ms.none,
                            ms.rays / (ms.frame + ms.build),
                            stats.memory.bytesPerNode,
                            nodesMean(stats),
                            double(stats.memory.bytesReserved) / 1e6,
                            ms.none,
                            ms.frame,
                            ms.build,
                            ms.rays};
  for (std::size_t i = 0; i < table.rows.size(); ++i) table.rows[i].ours.push_back(figures[i]);
}

}  // namespace

std::vector<Table> benchDemo(const BenchOptions& options) {
  const double rate = engine::trilinearRate(options.device, options.runs | 1);
  std::vector<double> raysRatios;
  for (const BenchScene& scene : kScenes) raysRatios.push_back(scene.wantedRaysRatio);
  Table table{
      "demo",
      "One light, a map of " + mapSizeText(options, kMapSize, 1) + "; " + numberText(rate) +
          " million trilinear samples / s",
      "scene",
      {},
      {plainRow("frame with shadows / frame without", "", {1.25, 1.25, 1.25}),
       plainRow("trilinear samples per shaded sample", "", {20, 20, 20}),
       plainRow("building the map / frame without shadows", "", {0.4, 0.4, 0.4}),
       plainRow("frame with shadow rays / (frame + map), at least", "", std::move(raysRatios)),
       plainRow("bytes per node", "", {8, 8, 8}), plainRow("nodes per texel, mean"), plainRow("memory reserved", "MB"),
       plainRow("frame without shadows", "ms"), plainRow("frame with shadows", "ms"),
       plainRow("building the map", "ms"), plainRow("frame with shadow rays", "ms")}};
  for (const BenchScene& entry : kScenes) {
    const Scene scene = sceneOf(options, entry.file);
    Subject maps(options, scene);
    const Times ms = measure(options, maps, scene);
    table.columns.push_back(entry.name);
    addColumn(table, ms, maps.stats(), rate);
  }
  return {table};
}

}  // namespace cdsm::cli
