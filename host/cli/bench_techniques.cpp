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

bool isCached(const Way& way) { return std::string(way.cache) == "volume"; }

/// Frames with a cache relative to frames without shadows, with the floor and without: what is outside of all volumes
/// is not in their shadow volumes.
class Cached {
 public:
  explicit Cached(const BenchOptions& options) {
    Scene plain = sceneOf(options, kWays[0]);
    plain.meshes.clear();
    add(options, std::move(plain));
    for (const Way& way : kWays) {
      if (!isCached(way)) continue;
      table_.columns.push_back(way.name);
      Scene alone = sceneOf(options, way);
      alone.meshes.clear();
      add(options, std::move(alone));
    }
  }

  /// What is to be measured besides frames with the floor.
  const std::vector<Measurement>& measurements() const { return measurements_; }

  /// `withFloor`: of all ways; `alone`: of measurements().
  Table table(const std::vector<double>& withFloor, const std::vector<double>& alone) const {
    Table table = table_;
    Row& all = table.rows[0];
    for (std::size_t i = 0; i < std::size(kWays); ++i)
      if (isCached(kWays[i])) all.ours.push_back(withFloor[i] / withFloor[0]);
    for (std::size_t i = 1; i < alone.size(); ++i) table.rows[1].ours.push_back(alone[i] / alone[0]);
    for (Row& row : table.rows) row.wanted.assign(row.ours.size(), kWantedCached);
    return table;
  }

 private:
  void add(const BenchOptions& options, Scene scene) {
    subjects_.push_back(std::make_unique<Subject>(options, std::move(scene)));
    measurements_.push_back([&subject = *subjects_.back()] {
      return std::vector<double>{kNoFigure, subject.frameMs()};
    });
  }

  Subjects subjects_;
  std::vector<Measurement> measurements_;
  Table table_{"cached",
               "What the project wants to reach: frame, cached / frame without shadows",
               "technique",
               {},
               {plainRow("volume and floor"), plainRow("volume alone")},
               {}};
};

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
  const Cached cached(options);
  measurements.insert(measurements.end(), cached.measurements().begin(), cached.measurements().end());
  std::vector<std::vector<double>> times = mediansInTurn(options, measurements);
  const auto ways = std::ptrdiff_t(std::size(kWays));
  const std::vector<double> alone(times[1].begin() + ways, times[1].end());
  for (std::vector<double>& row : times) row.resize(std::size(kWays));
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
  return {ours, paper, cached.table(times[1], alone)};
}

}  // namespace cdsm::cli
