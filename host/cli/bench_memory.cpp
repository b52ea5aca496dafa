// SPDX-License-Identifier: Apache-2.0
// Suite "memory": strategies and formats of nodes side by side, on scenes and sizes of maps. All hold the same
// functions; what differs is the room they take and the time it takes to build them and to look them up.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "bench_points.hpp"
#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr std::size_t kLookups = 1000000;
constexpr int kLargestTruth = 1024;  ///< texels per side up to which functions fit that are not compressed

constexpr const char* kStrategies[] = {"atlas", "chunked", "exact", "tiled", "fixed"};
constexpr const char* kFormats[] = {"float32", "unorm16"};
const std::vector<std::string> kScenes = {"papers/clustering/camera_b.toml", "bench/smoke.toml"};
const std::vector<int> kMapSizes = {512, 1024, 2048};

struct Variant {
  std::string strategy, format;
};

std::vector<Variant> allVariants() {
  std::vector<Variant> variants;
  for (const char* format : kFormats)
    for (const char* strategy : kStrategies) variants.push_back({strategy, format});
  return variants;
}

/// Figures that are timed, in the order in which they are measured.
enum Timed : std::size_t { kBuild, kAlong, kAnywhere, kFrame, kTimedCount };

/// A variant that is measured, or why it cannot be.
struct Entry {
  Variant variant;
  std::unique_ptr<Subject> subject;
  std::vector<double> timed = std::vector<double>(kTimedCount, kNoFigure);
  double largestError = kNoFigure, rmsError = kNoFigure;
};

double texelsOf(const FrameStats& stats) {
  double texels = 0.0;
  for (const LightStats& light : stats.lights)
    for (const MapStats& map : light.maps) texels += double(map.texels);
  return texels;
}

/// What light arrives at points of a scene whose functions are those of single texels.
std::vector<Transmittance> nearestLight(Subject& subject, const std::vector<glm::vec3>& points) {
  const std::string filter = std::exchange(subject.scene().shadows.filter, "nearest");
  std::vector<Transmittance> light = subject.transmittance(points);
  subject.scene().shadows.filter = filter;
  return light;
}

/// The light of functions that keep every sample.
std::vector<Transmittance> trueLight(const BenchOptions& options, Scene scene, const std::vector<glm::vec3>& points) {
  scene.shadows.memory = "exact";
  scene.shadows.tolerance = 0.0f;
  scene.shadows.toleranceMode = "samples";
  Subject subject(options, scene);
  return nearestLight(subject, points);
}

void compare(Entry& entry, const std::vector<Transmittance>& truth, const std::vector<glm::vec3>& points) {
  const std::vector<Transmittance> light = nearestLight(*entry.subject, points);
  double largest = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    const double error = std::abs(double(light[i].transmittance) - double(truth[i].transmittance));
    largest = std::max(largest, error);
    squares += error * error;
  }
  entry.largestError = largest;
  entry.rmsError = std::sqrt(squares / double(light.size()));
}

/// Entries of one scene at one size; those that do not fit have no subject, and `notes` gets the reason.
std::vector<Entry> entriesOf(const BenchOptions& options, const Scene& scene, std::vector<std::string>& notes) {
  std::vector<Entry> entries;
  for (const Variant& variant : allVariants()) {
    Scene stored = scene;
    stored.shadows.memory = variant.strategy;
    stored.shadows.nodeFormat = variant.format;
    entries.push_back({variant, std::make_unique<Subject>(options, stored)});
    try {
      entries.back().subject->frameMs();
    } catch (const Error& error) {
      notes.push_back(variant.strategy + ", " + variant.format + ": " + error.what());
      entries.back().subject.reset();
    }
  }
  return entries;
}

void measureTimes(const BenchOptions& options, std::vector<Entry>& entries, const LookupPoints& points) {
  std::vector<Measurement> measurements;
  std::vector<Entry*> measured;
  for (Entry& entry : entries) {
    if (!entry.subject) continue;
    measured.push_back(&entry);
    measurements.push_back([&subject = *entry.subject, &points] {
      const double build = subject.buildMs();
      return std::vector<double>{build, subject.lookupMs(points.along), subject.lookupMs(points.anywhere),
                                 subject.frameMs()};
    });
  }
  const std::vector<std::vector<double>> times = mediansInTurn(options, measurements);
  for (std::size_t i = 0; i < measured.size(); ++i)
    for (std::size_t k = 0; k < kTimedCount; ++k) measured[i]->timed[k] = times[k][i];
}

Table tableOf(const std::vector<Entry>& entries, const std::string& title, std::vector<std::string> notes) {
  Table table{"", title, "strategy, node format", {}, {}, std::move(notes)};
  for (const Entry& entry : entries) table.columns.push_back(entry.variant.strategy + ", " + entry.variant.format);
  const auto row = [&](const char* label, const char* unit, const auto& figure) {
    Row line = plainRow(label, unit);
    for (const Entry& entry : entries) line.ours.push_back(entry.subject ? figure(entry) : kNoFigure);
    table.rows.push_back(line);
  };
  const auto perTexel = [](const Entry& entry, std::uint64_t bytes) {
    return double(bytes) / texelsOf(entry.subject->stats());
  };
  const auto memoryOf = [](const Entry& entry) -> const MemoryStats& { return entry.subject->stats().memory; };
  row("reserved", "bytes / texel", [&](const Entry& e) { return perTexel(e, memoryOf(e).bytesReserved); });
  row("used", "bytes / texel", [&](const Entry& e) { return perTexel(e, memoryOf(e).bytesUsed); });
  row("wasted", "bytes / texel", [&](const Entry& e) { return perTexel(e, memoryOf(e).bytesWasted); });
  row("reserved", "bytes / node", [&](const Entry& e) {
    return double(memoryOf(e).bytesReserved) / (nodesMean(e.subject->stats()) * texelsOf(e.subject->stats()));
  });
  row("nodes per texel", "", [](const Entry& e) { return nodesMean(e.subject->stats()); });
  row("building maps", "ms", [](const Entry& e) { return e.timed[kBuild]; });
  row("a million lookups along lines", "ms", [](const Entry& e) { return e.timed[kAlong]; });
  row("a million lookups anywhere", "ms", [](const Entry& e) { return e.timed[kAnywhere]; });
  row("frame, filtered", "ms", [](const Entry& e) { return e.timed[kFrame]; });
  row("error, largest", "", [](const Entry& e) { return e.largestError; });
  row("error, RMS", "", [](const Entry& e) { return e.rmsError; });
  return table;
}

const Entry& entryOf(const std::vector<Entry>& entries, const std::string& strategy, const std::string& format) {
  return *std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
    return entry.variant.strategy == strategy && entry.variant.format == format;
  });
}

double timeRatio(const std::vector<Entry>& entries, Timed figure, const char* strategy, const char* other) {
  return entryOf(entries, strategy, "float32").timed[figure] / entryOf(entries, other, "float32").timed[figure];
}

/// What the project set itself as goals, a column for each size.
Table goalsTable(const std::string& title, std::size_t columns) {
  const auto wanted = [columns](double value) { return std::vector<double>(columns, value); };
  return {"",
          title,
          "maps",
          {},
          {plainRow("exact with unorm16", "bytes / texel", wanted(20)),
           plainRow("wasted by exact, part of its bytes", "", wanted(0)),
           plainRow("wasted by chunked, part of its bytes", "", wanted(0.05)),
           plainRow("lookups along lines, exact / atlas", "", wanted(1)),
           plainRow("lookups anywhere, exact / atlas", "", wanted(1)),
           plainRow("building maps, exact / chunked", "", wanted(1.1))}};
}

void addGoals(Table& goals, const std::vector<Entry>& entries) {
  const auto memory = [&](const char* strategy, const char* format, const auto& figure) {
    const Entry& entry = entryOf(entries, strategy, format);
    return entry.subject ? figure(entry.subject->stats()) : kNoFigure;
  };
  const auto wasted = [](const FrameStats& stats) {
    return double(stats.memory.bytesWasted) / std::max(1.0, double(stats.memory.bytesReserved));
  };
  const double figures[] = {
      memory("exact", "unorm16",
             [](const FrameStats& stats) { return double(stats.memory.bytesReserved) / texelsOf(stats); }),
      memory("exact", "float32", wasted),
      memory("chunked", "float32", wasted),
      timeRatio(entries, kAlong, "exact", "atlas"),
      timeRatio(entries, kAnywhere, "exact", "atlas"),
      timeRatio(entries, kBuild, "exact", "chunked")};
  for (std::size_t i = 0; i < goals.rows.size(); ++i) goals.rows[i].ours.push_back(figures[i]);
}

/// Tables of one scene: what the goals are about, then everything for each size.
std::vector<Table> tablesOf(const BenchOptions& options, const std::string& name, const Scene& scene) {
  const std::vector<int>& sizes = options.mapSizes.empty() ? kMapSizes : options.mapSizes;
  if (scene.lights.empty()) throw Error(name + " has no light, must have one to be shadowed");
  LookupPoints points;
  {
    Engine engine(engineOptions(options));
    points = lookupPoints(engine, scene, scene.lights.front().name, kLookups);
  }
  std::vector<Table> tables = {goalsTable(name + ": what the project wants to reach", sizes.size())};
  for (const int size : sizes) {
    const Scene sized = withMaps(options, scene, size, 1, "exact");
    std::vector<std::string> notes;
    std::vector<Entry> entries = entriesOf(options, sized, notes);
    if (size <= kLargestTruth) {
      const std::vector<Transmittance> truth = trueLight(options, sized, points.anywhere);
      for (Entry& entry : entries)
        if (entry.subject) compare(entry, truth, points.anywhere);
    }
    measureTimes(options, entries, points);
    const std::string maps = mapSizeText(options, size, 1);
    tables.push_back(tableOf(entries, name + ", " + maps, notes));
    tables.front().columns.push_back(maps);
    addGoals(tables.front(), entries);
  }
  return tables;
}

/// "clustering/camera_b" of "papers/clustering/camera_b.toml".
std::string sceneName(const std::string& file) {
  const std::size_t end = file.rfind(".toml"), slash = file.rfind('/');
  const std::size_t folder = slash == std::string::npos || slash == 0 ? slash : file.rfind('/', slash - 1);
  return file.substr(folder == std::string::npos ? 0 : folder + 1, end == std::string::npos ? end : end - folder - 1);
}

}  // namespace

std::vector<Table> benchMemory(const BenchOptions& options) {
  std::vector<Table> tables;
  const auto add = [&](const std::string& file, const Scene& scene) {
    std::vector<Table> more = tablesOf(options, sceneName(file), scene);
    std::move(more.begin(), more.end(), std::back_inserter(tables));
    for (std::size_t i = 0; i < tables.size(); ++i) tables[i].name = std::to_string(i);
  };
  if (options.files.empty())
    for (const std::string& file : kScenes) add(file, readBenchScene(options, file));
  for (const std::string& file : options.files) add(file, readAnyScene(options, file));
  return tables;
}

}  // namespace cdsm::cli
