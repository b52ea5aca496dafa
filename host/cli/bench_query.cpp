// SPDX-License-Identifier: Apache-2.0
// Suite "query": transmittances at points in arrays of the host, from a finished map: wall clock of the call beside the
// time of the bare kernel on the device.
#include <algorithm>
#include <chrono>

#include "bench_points.hpp"
#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr int kMapSize = 512;
constexpr double kPoints = 1e6;  // at the whole scale
constexpr double kWantedRates[] = {20.0, 5.0}, kWantedShare = 0.7;

struct CallTimes {
  double wall, kernel;  ///< ms; kernel: 0 on a queue without times
};

CallTimes timesOfCall(Engine& engine, const std::string& light, const std::vector<glm::vec3>& points,
                      std::vector<float>& values) {
  const auto begun = std::chrono::steady_clock::now();
  engine.transmittance(light, points.data(), points.size(), values.data());
  const double wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
  return {wall, engine.stats().renderMs};
}

/// Million points a second.
double rateOf(std::size_t points, double milliseconds) {
  return milliseconds > 0.0 ? double(points) / (1000.0 * milliseconds) : kNoFigure;
}

}  // namespace

std::vector<Table> benchQuery(const BenchOptions& options) {
  Scene scene = withMaps(options, readBenchScene(options, "bench/sparse.toml"), kMapSize, 1, "chunked");
  const std::string light = scene.lights.front().name;
  const auto count = std::size_t(std::max(1.0, kPoints * options.scale * options.scale));
  Engine engine(engineOptions(options));
  const LookupPoints points = lookupPoints(engine, scene, light, count);
  engine.prepare(scene);
  std::vector<float> values(count);
  const auto measure = [&](const std::vector<glm::vec3>& list) {
    return [&] {
      const CallTimes ms = timesOfCall(engine, light, list, values);
      return std::vector<double>{ms.wall, ms.kernel, ms.kernel / ms.wall};
    };
  };
  const auto ms = mediansInTurn(options, {measure(points.along), measure(points.anywhere)});
  Table table{"query",
              std::to_string(count) + " points in arrays of the host, a map of " + mapSizeText(options, kMapSize, 1),
              "points",
              {"along rays", "at random"},
              {plainRow("host arrays, at least", "M points / s"), plainRow("bare kernel", "M points / s"),
               plainRow("host arrays / bare kernel, at least", "", {kWantedShare, kWantedShare})}};
  table.rows[0].wanted.assign(std::begin(kWantedRates), std::end(kWantedRates));
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    table.rows[0].ours.push_back(rateOf(count, ms[0][i]));
    table.rows[1].ours.push_back(rateOf(count, ms[1][i]));
    table.rows[2].ours.push_back(ms[1][i] > 0.0 ? ms[2][i] : kNoFigure);
  }
  return {table};
}

}  // namespace cdsm::cli
