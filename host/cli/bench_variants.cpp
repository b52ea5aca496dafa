// SPDX-License-Identifier: Apache-2.0
#include "bench_variants.hpp"

namespace cdsm::cli {
namespace {

constexpr int kMapSize = 256, kClusters = 4;

struct Measured {
  Subjects subjects;
  std::vector<double> build, frame;
};

std::vector<Measured> subjectsOf(const BenchOptions& options, const std::vector<Scene>& variants,
                                 const std::vector<ThesisTimes>& times) {
  std::vector<Measured> all(times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    for (const Scene& scene : variants)
      all[i].subjects.push_back(
          std::make_unique<Subject>(options, withMaps(options, scene, kMapSize, kClusters, times[i].memory)));
  return all;
}

void measure(const BenchOptions& options, std::vector<Measured>& all) {
  std::vector<Measurement> measurements;
  for (Measured& measured : all) {
    for (const auto& subject : measured.subjects) {
      measurements.push_back([&subject] {
        const double build = subject->buildMs();
        return std::vector<double>{build, subject->frameMs()};
      });
    }
  }
  const std::vector<std::vector<double>> medians = mediansInTurn(options, measurements);
  std::size_t next = 0;
  for (Measured& measured : all) {
    for (std::size_t i = 0; i < measured.subjects.size(); ++i, ++next) {
      measured.build.push_back(medians[0][next]);
      measured.frame.push_back(medians[1][next]);
    }
  }
}

}  // namespace

std::vector<Table> benchVariants(const BenchOptions& options, const std::string& parameter,
                                 const std::vector<std::string>& columns, const std::vector<Scene>& variants,
                                 const std::vector<ThesisTimes>& times, const ThesisNodes& nodes) {
  std::vector<Measured> all = subjectsOf(options, variants, times);
  measure(options, all);
  const std::string maps = mapSizeText(options, kMapSize, kClusters);
  std::vector<Table> tables;
  for (std::size_t i = 0; i < times.size(); ++i) {
    tables.push_back({times[i].name,
                      "Table " + times[i].name + ": " + times[i].title + ", " + maps +
                          " for each light; ratios to the smallest of a row in the thesis",
                      parameter,
                      columns,
                      {rowToSmallest("building maps", "ms", all[i].build, times[i].build),
                       rowToSmallest("frame, filtered", "ms", all[i].frame, times[i].frame)}});
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i].memory == "chunked")
      tables.push_back({nodes.name, "Table " + nodes.name + ": what the maps hold, " + maps + " for each light",
                        parameter, columns, mapRows(all[i].subjects, nodes.mean, nodes.most)});
  }
  return tables;
}

}  // namespace cdsm::cli
