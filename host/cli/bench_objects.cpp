// SPDX-License-Identifier: Apache-2.0
// Suite "objects" [Knecht 2011, Figure 5.13]: 1 to 24 steaming teacups, four clusters of 256^2. The thesis has a
// diagram without numbers: all its times grow linearly, exponent 1.
#include <iterator>

#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

const std::vector<int> kCups = {1, 2, 4, 8, 12, 16, 24};
const char* const kMemories[] = {"chunked", "atlas"};
const char* const kSteps[] = {"clustering", "building maps", "frame, filtered"};
constexpr double kLinear = 1.0;
constexpr int kMapSize = 256, kClusters = 4;

std::string sceneOf(int cups) {
  return "papers/teacups/teacups_" + std::string(cups < 10 ? "0" : "") + std::to_string(cups) + ".toml";
}

Measurement ofSteps(Subject& subject) {
  return [&subject] {
    const double build = subject.buildMs();
    const double cluster = subject.clusterMs();
    return std::vector<double>{cluster, build, subject.frameMs()};
  };
}

/// `medians` by figure, those of the table from `first` on.
Table tableOf(const BenchOptions& options, const std::string& memory, const std::vector<std::vector<double>>& medians,
              std::size_t first) {
  const std::string maps = mapSizeText(options, kMapSize, kClusters);
  Table table{memory, "Figure 5.13: " + memory + ", " + maps + "; ratios to the smallest of a row", "teacups", {}, {}};
  for (const int cups : kCups) table.columns.push_back(std::to_string(cups));
  for (std::size_t step = 0; step < std::size(kSteps); ++step)
    table.rows.push_back(rowToSmallest(kSteps[step], "ms", slice(medians[step], first, kCups.size()), {}));
  return table;
}

/// One column for each of the tables.
Table exponentsOf(const std::vector<Table>& tables) {
  Table exponents{"exponents", "Exponents p of the power laws c n^p of n teacups that fit best", "memory", {}, {}};
  for (const char* step : kSteps)
    exponents.rows.push_back(plainRow(step, "", std::vector<double>(tables.size(), kLinear)));
  for (const Table& table : tables) {
    exponents.columns.push_back(table.name);
    for (std::size_t step = 0; step < std::size(kSteps); ++step)
      exponents.rows[step].ours.push_back(powerLawExponent({kCups.begin(), kCups.end()}, table.rows[step].ours));
  }
  return exponents;
}

}  // namespace

std::vector<Table> benchObjects(const BenchOptions& options) {
  Subjects subjects;
  std::vector<Measurement> measurements;
  for (const char* memory : kMemories) {
    for (const int cups : kCups) {
      const Scene scene = readBenchScene(options, sceneOf(cups));
      subjects.push_back(std::make_unique<Subject>(options, withMaps(options, scene, kMapSize, kClusters, memory)));
      measurements.push_back(ofSteps(*subjects.back()));
    }
  }
  const std::vector<std::vector<double>> medians = mediansInTurn(options, measurements);
  std::vector<Table> tables;
  for (const char* memory : kMemories)
    tables.push_back(tableOf(options, memory, medians, tables.size() * kCups.size()));
  tables.push_back(exponentsOf(tables));
  return tables;
}

}  // namespace cdsm::cli
