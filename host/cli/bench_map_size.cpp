// SPDX-License-Identifier: Apache-2.0
// Suite "map-size" [Knecht 2011, Tables 5.1 to 5.4]: the clustering scene from its second camera, maps of three sizes,
// one map or four clusters, in both kinds of memory.
#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr double kThesisUnshadowedMs = 43.0;  // [Knecht 2011, §5.7.1]

/// One table of the thesis, all of milliseconds.
struct Case {
  const char* name;
  const char* memory;
  const char* title;
  int clusters;
  std::vector<int> mapSizes;
  std::vector<double> build, nearest, bilinear;
};

const std::vector<Case> kCases = {
    {"5.1",
     "atlas",
     "atlas (thesis: 3D textures), no clusters",
     1,
     {256, 512, 1024},
     {11, 31, 65},
     {46, 46, 46},
     {54, 53, 53}},
    {"5.2",
     "atlas",
     "atlas (thesis: 3D textures), four clusters",
     4,
     {128, 256, 512},
     {21, 40, 80},
     {54, 55, 57},
     {70, 71, 72}},
    {"5.3", "chunked", "chunked, no clusters", 1, {256, 512, 1024}, {7, 17, 54}, {48, 49, 49}, {56, 56, 57}},
    {"5.4", "chunked", "chunked, four clusters", 4, {128, 256, 512}, {17, 30, 79}, {55, 56, 57}, {69, 69, 70}},
};

/// What is measured of a map: building it, a frame of either filter.
Measurement ofMaps(Subject& subject) {
  return [&subject] {
    const double build = subject.buildMs();
    return std::vector<double>{build, subject.frameMs("nearest"), subject.frameMs("bilinear")};
  };
}

/// `times` by figure, those of the table from `first` on; `none`: the frame without shadows.
Table tableOf(const BenchOptions& options, const Case& entry, const Subjects& subjects,
              const std::vector<std::vector<double>>& times, std::size_t first, double none) {
  const std::string title = "Table " + std::string(entry.name) + ": " + entry.title;
  Table table{entry.name, title + "; ratios to a frame without shadows", "texels of maps", {}, mapRows(subjects)};
  for (const int size : entry.mapSizes) table.columns.push_back(mapSizeText(options, size, entry.clusters));
  const auto row = [&](const char* label, std::size_t figure, const std::vector<double>& thesis) {
    return rowToBase(label, slice(times[figure], first, thesis.size()), none, thesis, kThesisUnshadowedMs);
  };
  table.rows.insert(table.rows.begin(),
                    {row("building maps", 0, entry.build), row("frame, not filtered", 1, entry.nearest),
                     row("frame, filtered", 2, entry.bilinear)});
  return table;
}

}  // namespace

std::vector<Table> benchMapSize(const BenchOptions& options) {
  const Scene scene = readBenchScene(options, "papers/clustering/camera_b.toml");
  Scene plain = scene;
  plain.shadows.technique = "none";
  Subject unshadowed(options, plain);
  std::vector<Subjects> subjects(kCases.size());
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < kCases.size(); ++i) {
    for (const int size : kCases[i].mapSizes) {
      const Scene sized = withMaps(options, scene, size, kCases[i].clusters, kCases[i].memory);
      subjects[i].push_back(std::make_unique<Subject>(options, sized));
      measurements.push_back(ofMaps(*subjects[i].back()));
    }
  }
  measurements.push_back([&] { return std::vector<double>(3, unshadowed.frameMs()); });
  const std::vector<std::vector<double>> times = mediansInTurn(options, measurements);

  const double none = times[0].back();
  std::vector<Table> tables = {
      {"unshadowed", "Frame without shadows", "", {""}, {rowToBase("frame", {none}, 0.0, {kThesisUnshadowedMs}, 0.0)}}};
  std::size_t first = 0;
  for (std::size_t i = 0; i < kCases.size(); ++i) {
    tables.push_back(tableOf(options, kCases[i], subjects[i], times, first, none));
    first += subjects[i].size();
  }
  return tables;
}

}  // namespace cdsm::cli
