// SPDX-License-Identifier: Apache-2.0
// Suite "stochastic" [Weidner & Linsen 2018, Tables 3 and 4]: the test spheres with maps of three sizes by three
// techniques, and the noise of stratified numbers.
#include <cmath>

#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

const std::vector<int> kMapSizes = {1024, 2048, 4096};
const std::vector<int> kSamples = {7, 13, 21};

struct Technique {
  const char* name;
  const char* label;
  bool stratified;
  std::vector<double> build, frame;  ///< ms of the paper
};

const std::vector<Technique> kTechniques = {
    {"shadow-map", "shadow map", false, {1.0, 2.9, 8.5}, {3.2, 3.2, 3.3}},
    {"deep-shadow-map", "deep shadow map", false, {1.1, 3.3, 10.5}, {3.3, 3.1, 3.4}},
    {"stochastic", "stochastic", false, {1.2, 3.6, 11.1}, {4.9, 4.7, 4.9}},
    {"stochastic", "stochastic, stratified", true, {}, {}}};
constexpr std::size_t kShadowMap = 0, kDeepShadowMap = 1, kStochastic = 2;

Scene benchScene(const BenchOptions& options) { return readBenchScene(options, "papers/test-spheres/scene.toml"); }

/// By technique: milliseconds to build, of a frame, megabytes.
using Figures = std::vector<std::vector<double>>;

Figures measure(const BenchOptions& options, int mapSize) {
  Subjects subjects;
  std::vector<Measurement> measurements;
  for (const Technique& technique : kTechniques) {
    Scene scene = withMaps(options, benchScene(options), mapSize, 1, "chunked");
    scene.shadows.technique = technique.name;
    scene.shadows.stratified = technique.stratified;
    subjects.push_back(std::make_unique<Subject>(options, scene));
    measurements.push_back([&subject = *subjects.back()] {
      const double build = subject.buildMs();
      subject.render();
      return std::vector<double>{build, subject.frameMs(), double(subject.stats().memory.bytesReserved) / 1e6};
    });
  }
  const auto byFigure = mediansInTurn(options, measurements);
  Figures figures;
  for (std::size_t i = 0; i < subjects.size(); ++i) figures.push_back({byFigure[0][i], byFigure[1][i], byFigure[2][i]});
  return figures;
}

/// Figure number `figure` of one technique, over the sizes.
std::vector<double> overSizes(const std::vector<Figures>& bySize, std::size_t technique, std::size_t figure) {
  std::vector<double> values;
  for (const Figures& figures : bySize) values.push_back(figures[technique][figure]);
  return values;
}

std::vector<double> quotients(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> values;
  for (std::size_t i = 0; i < a.size(); ++i) values.push_back(a[i] / b[i]);
  return values;
}

/// A table of times: all techniques, then stochastic shadows by those of the other two. `wanted`: of the ratio to
/// technique number `judge`.
Table timesOf(const BenchOptions& options, const std::vector<Figures>& bySize, std::size_t figure, const char* name,
              const char* title, std::size_t judge, double wanted) {
  const auto paper = [figure](std::size_t i) { return figure == 0 ? kTechniques[i].build : kTechniques[i].frame; };
  Table table{name, title, "texels of maps", {}, {}, {}, "paper"};
  for (const int size : kMapSizes) table.columns.push_back(mapSizeText(options, size, 1));
  for (const std::size_t base : {kShadowMap, kDeepShadowMap}) {
    Row row = plainRow(std::string("stochastic / ") + kTechniques[base].label);
    row.ours = quotients(overSizes(bySize, kStochastic, figure), overSizes(bySize, base, figure));
    row.thesis = quotients(paper(kStochastic), paper(base));
    if (base == judge) row.wanted.assign(kMapSizes.size(), wanted);
    table.rows.push_back(row);
  }
  for (std::size_t i = 0; i < kTechniques.size(); ++i) {
    Row row = plainRow(kTechniques[i].label, "ms");
    row.ours = overSizes(bySize, i, figure);
    row.thesis = paper(i);
    table.rows.push_back(row);
  }
  return table;
}

Table memoryOf(const BenchOptions& options, const std::vector<Figures>& bySize) {
  Table table{"memory", "Memory of the maps", "texels of maps", {}, {}, {}, "paper"};
  for (const int size : kMapSizes) table.columns.push_back(mapSizeText(options, size, 1));
  for (std::size_t i = 0; i <= kStochastic; ++i) {
    table.rows.push_back(plainRow(kTechniques[i].label, "MB"));
    table.rows.back().ours = overSizes(bySize, i, 2);
  }
  return table;
}

/// Standard deviation of a pixel over the seeds, root of the mean square over pixels and channels, from two of them.
double noiseOf(Subject& subject, bool stratified, int samples) {
  subject.scene().shadows.stratified = stratified;
  subject.scene().shadows.samples = samples;
  const Image images[] = {(subject.scene().shadows.seed = 1, subject.render()),
                          (subject.scene().shadows.seed = 2, subject.render())};
  double squares = 0.0;
  for (std::size_t i = 0; i < images[0].pixels.size(); ++i) {
    const glm::dvec3 difference(images[0].pixels[i] - images[1].pixels[i]);
    squares += glm::dot(difference, difference);
  }
  return std::sqrt(squares / (2.0 * 3.0 * double(images[0].pixels.size())));
}

Table noiseTable(const BenchOptions& options) {
  Scene scene = withMaps(options, benchScene(options), kMapSizes.front(), 1, "chunked");
  scene.shadows.technique = "stochastic";
  Subject subject(options, scene);
  Row published = plainRow("as published"), stratified = plainRow("stratified"), ratio = plainRow("ratio");
  Table table{"noise",   "Noise of a pixel, linear colours, maps of " + mapSizeText(options, kMapSizes.front(), 1),
              "samples", {},
              {},        {},
              "paper"};
  for (const int samples : kSamples) {
    table.columns.push_back(std::to_string(samples));
    published.ours.push_back(noiseOf(subject, false, samples));
    stratified.ours.push_back(noiseOf(subject, true, samples));
  }
  ratio.ours = quotients(stratified.ours, published.ours);
  ratio.wanted.assign(kSamples.size(), 0.5);
  table.rows = {ratio, published, stratified};
  return table;
}

}  // namespace

std::vector<Table> benchStochastic(const BenchOptions& options) {
  std::vector<Figures> bySize;
  for (const int size : kMapSizes) bySize.push_back(measure(options, size));
  return {timesOf(options, bySize, 0, "weidner-3", "Weidner's Table 3: building maps", kShadowMap, 1.2),
          timesOf(options, bySize, 1, "weidner-4", "Weidner's Table 4: frames", kDeepShadowMap, 1.5),
          memoryOf(options, bySize), noiseTable(options)};
}

}  // namespace cdsm::cli
