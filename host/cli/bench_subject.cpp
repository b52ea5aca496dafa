// SPDX-License-Identifier: Apache-2.0
#include "bench_subject.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <cdsm/error.hpp>

#include "io/scene_file.hpp"

namespace cdsm::cli {
namespace {

constexpr int kPartsOfSide = 240;  // 720 x 480 pixels are 3 x 2 of these
constexpr int kSmallestMap = 8;    // texels per side that a scene may ask for

int scaled(double scale, int side) { return std::max(1, int(std::lround(scale * side))); }

/// Which script makes a missing file, or how to find it.
std::string remedyFor(const BenchOptions& options, const std::string& file) {
  const auto script = [&options](const char* path) { return "'python3 " + options.scenes + path + "' makes it"; };
  if (file.find("/generated/") != std::string::npos) return script("/papers/make_data.py");
  if (file.find("/bench/smoke.nrrd") != std::string::npos) return script("/bench/make_smoke.py");
  return "--scenes must name the folder with demo/, bench/ and papers/";
}

/// A scene as all suites measure it.
Scene prepared(const BenchOptions& options, Scene scene) {
  scene.image.width = 3 * scaled(options.scale, kPartsOfSide);
  scene.image.height = 2 * scaled(options.scale, kPartsOfSide);
  scene.image.supersampling = 1;
  scene.shadows.technique = "deep-shadow-map";
  scene.shadows.memory = "chunked";
  scene.shadows.filter = "bilinear";
  scene.shadows.tolerance = 0.01f;
  scene.shadows.nodeFormat = "float32";
  scene.shadows.transmittance = "grey";
  scene.shadows.cache = "none";
  return scene;
}

}  // namespace

EngineOptions engineOptions(const BenchOptions& options) {
  EngineOptions engine;
  engine.device = options.device;
  return engine;
}

Scene readBenchScene(const BenchOptions& options, const std::string& file) {
  try {
    return prepared(options, io::readScene(options.scenes + "/" + file));
  } catch (const Error& error) {
    const std::string missing = error.where() ? error.where()->file : "";
    if (missing.empty() || std::filesystem::exists(missing)) throw;
    throw Error(Location{missing}, "there is no such file; " + remedyFor(options, missing));
  }
}

Scene readAnyScene(const BenchOptions& options, const std::string& path) {
  return prepared(options, io::readScene(path));
}

int scaledMapSize(const BenchOptions& options, int mapSize) {
  return std::max(kSmallestMap, scaled(options.scale, mapSize));
}

Scene withMaps(const BenchOptions& options, Scene scene, int mapSize, int clusters, const std::string& memory) {
  scene.shadows.mapSize = scaledMapSize(options, mapSize);
  scene.shadows.clusters = clusters;
  scene.shadows.memory = memory;
  return scene;
}

std::string mapSizeText(const BenchOptions& options, int mapSize, int clusters) {
  const std::string text = std::to_string(scaledMapSize(options, mapSize)) + "^2";
  return clusters > 1 ? std::to_string(clusters) + " x " + text : text;
}

Subject::Subject(const BenchOptions& options, Scene scene)
    : engine_(engineOptions(options)), scene_(std::move(scene)) {}

double Subject::frameMs() {
  const bool first = engine_.stats().lights.empty();
  const double milliseconds = renderMs(engine_, scene_);
  const bool filled = stats().cache && stats().cache->filled;
  if (!first && (filled || builtMaps(stats()) > 0))
    throw Error("shadows were built in a frame that must be timed without");
  return milliseconds;
}

double Subject::frameMs(const std::string& filter) {
  scene_.shadows.filter = filter;
  return frameMs();
}

double Subject::frameMs(const Camera& camera) {
  scene_.camera = camera;
  return renderMs(engine_, scene_);
}

double Subject::buildMs() { return cli::buildMs(engine_, scene_, nudged_); }

double Subject::lookupMs(const std::vector<glm::vec3>& points) {
  transmittance(points);
  return stats().renderMs;
}

std::vector<Transmittance> Subject::transmittance(const std::vector<glm::vec3>& points) {
  return engine_.transmittance(scene_, scene_.lights.front().name, points);
}

double Subject::movedLightMs() {
  nudgeLights(scene_, nudged_);
  return renderMs(engine_, scene_);
}

void Subject::shrinkImage() { scene_ = shrunk(std::move(scene_)); }

double nodesMean(const FrameStats& stats) {
  double nodes = 0.0, texels = 0.0;
  for (const LightStats& light : stats.lights) {
    for (const MapStats& map : light.maps) {
      nodes += double(map.nodesTotal);
      texels += double(map.texels);
    }
  }
  return texels > 0.0 ? nodes / texels : 0.0;
}

double nodesMax(const FrameStats& stats) {
  std::uint64_t most = 0;
  for (const LightStats& light : stats.lights)
    for (const MapStats& map : light.maps) most = std::max(most, map.nodesMax);
  return double(most);
}

std::vector<Row> mapRows(const Subjects& subjects, const std::vector<double>& mean, const std::vector<double>& most) {
  std::vector<Row> rows;
  const auto add = [&](Row row, const auto& figure) {
    for (const auto& subject : subjects) row.ours.push_back(double(figure(subject->stats())));
    rows.push_back(std::move(row));
  };
  add(plainRow("nodes per texel, mean"), nodesMean);
  rows.back().thesis = mean;
  add(plainRow("nodes per texel, most"), nodesMax);
  rows.back().thesis = most;
  add(plainRow("maps"), mapCount);
  add(plainRow("memory reserved", "MB"), [](const FrameStats& stats) { return stats.memory.bytesReserved / 1e6; });
  add(plainRow("memory wasted", "MB"), [](const FrameStats& stats) { return stats.memory.bytesWasted / 1e6; });
  if (subjects.front()->stats().memory.strategy != "chunked") return rows;
  add(plainRow("chunks used while building"), [](const FrameStats& stats) { return stats.memory.chunksUsed; });
  add(plainRow("chunks wasted while building"), [](const FrameStats& stats) { return stats.memory.chunksWasted; });
  return rows;
}

std::vector<std::vector<double>> mediansInTurn(const BenchOptions& options,
                                               const std::vector<Measurement>& measurements) {
  std::vector<std::vector<std::vector<double>>> figures(measurements.size());  // by measurement, figure, run
  for (int run = 0; run <= options.runs; ++run) {
    for (std::size_t i = 0; i < measurements.size(); ++i) {
      if (options.progress) {
        const double step = double(run) * double(measurements.size()) + double(i);
        options.progress("measure", float(step / (double(options.runs + 1) * double(measurements.size()))));
      }
      const std::vector<double> values = measurements[i]();
      figures[i].resize(values.size());
      for (std::size_t k = 0; run > 0 && k < values.size(); ++k) figures[i][k].push_back(values[k]);
    }
  }
  std::vector<std::vector<double>> medians;
  for (std::size_t k = 0; !figures.empty() && k < figures[0].size(); ++k) {
    medians.emplace_back();
    for (const auto& measured : figures) medians.back().push_back(median(measured[k]));
  }
  return medians;
}

}  // namespace cdsm::cli
