// SPDX-License-Identifier: Apache-2.0
// Suite "techniques" [Ropinski 2008, Tables 1 and 2]: every technique of that paper on one volume, with and without a
// shadow volume ("+pp" there), while the camera moves and while the light does.
#include <iterator>

#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr double kWantedCached = 1.1;

/// A way to make shadows; `cache` and frames per second as in the paper's Table 1, tuned for quality, and Table 2, for
/// speed: while the light moves, while the camera alone does. 0: it has no such entry.
struct Way {
  const char* name;
  const char* technique;
  const char* rays;
  const char* cache;
  double lightMoves[2], cameraMoves[2];
};

constexpr Way kWays[] = {
    {"none", "none", "exact", "none", {}, {}},
    {"opaque shadow rays", "shadow-rays", "opaque", "none", {7.98, 10.03}, {7.98, 10.03}},
    {"shadow rays", "shadow-rays", "exact", "none", {6.70, 10.00}, {6.70, 10.00}},
    {"opaque shadow rays, cached", "shadow-rays", "opaque", "volume", {4.25, 5.59}, {14.90, 46.00}},
    {"shadow rays, cached", "shadow-rays", "exact", "volume", {}, {}},
    {"shadow map", "shadow-map", "exact", "none", {12.50, 29.08}, {15.00, 45.50}},
    {"shadow map, cached", "shadow-map", "exact", "volume", {}, {}},
    {"deep shadow map", "deep-shadow-map", "exact", "none", {10.00, 15.76}, {14.90, 34.50}},
    {"deep shadow map, cached", "deep-shadow-map", "exact", "volume", {8.85, 13.06}, {14.90, 45.20}},
};

Scene sceneOf(const BenchOptions& options, const Way& way) {
  Scene scene = readBenchScene(options, "bench/sparse.toml");
  scene.shadows.technique = way.technique;
  scene.shadows.rays = way.rays;
  scene.shadows.cache = way.cache;
  return scene;
}

/// Frames per second of one of the paper's tables.
Row paperRow(const char* label, std::size_t table, const double (Way::*figures)[2]) {
  Row row = plainRow(label, "frames / s");
  for (const Way& way : kWays) {
    const double rate = (way.*figures)[table];
    row.thesis.push_back(rate > 0.0 ? rate : kNoFigure);
  }
  return row;
}

}  // namespace

std::vector<Table> benchTechniques(const BenchOptions& options) {
  Subjects subjects;
  std::vector<Measurement> measurements;
  for (const Way& way : kWays) {
    subjects.push_back(std::make_unique<Subject>(options, sceneOf(options, way)));
    measurements.push_back([&subject = *subjects.back()] {
      const double moved = subject.movedLightMs();
      return std::vector<double>{moved, subject.frameMs()};
    });
  }
  const std::vector<std::vector<double>> times = mediansInTurn(options, measurements);
  std::vector<std::string> names;
  for (const Way& way : kWays) names.push_back(way.name);
  const double none = times[1].front();
  const Table ours{
      "ours",
      "Frames here; ratios to a frame without shadows",
      "technique",
      names,
      {rowToBase("light moved", times[0], none, {}, 0.0), rowToBase("camera moved", times[1], none, {}, 0.0)},
      {}};
  const Table paper{
      "paper",
      "Ropinski 2008, Tables 1 (tuned for quality) and 2 (for speed)",
      "technique",
      names,
      {paperRow("light moved, Table 1", 0, &Way::lightMoves), paperRow("camera moved, Table 1", 0, &Way::cameraMoves),
       paperRow("light moved, Table 2", 1, &Way::lightMoves), paperRow("camera moved, Table 2", 1, &Way::cameraMoves)},
      {},
      "paper"};
  Table goal{
      "cached", "What the project wants to reach", "technique", {}, {plainRow("frame, cached / frame without shadows")},
      {}};
  for (std::size_t i = 0; i < std::size(kWays); ++i) {
    if (std::string(kWays[i].cache) == "none") continue;
    goal.columns.push_back(kWays[i].name);
    goal.rows[0].ours.push_back(times[1][i] / none);
    goal.rows[0].wanted.push_back(kWantedCached);
  }
  return {ours, paper, goal};
}

}  // namespace cdsm::cli
