// SPDX-License-Identifier: Apache-2.0
// What the suites measure with: scenes of the repository, an engine for each thing to be timed, medians in turn.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

#include "bench_tables.hpp"
#include "frame_times.hpp"

namespace cdsm::cli {

struct BenchOptions {
  std::string device;
  std::string scenes = "scenes";
  int runs = 5;
  double scale = 1.0;              ///< of image and map sides, in (0, 1]; below 1 for trying a suite out
  std::vector<std::string> files;  ///< suite "memory": scenes to measure; empty: its own
  std::vector<int> mapSizes;       ///< suite "memory": texels per side; empty: its own
  std::function<void(const std::string& step, float done)> progress;  ///< done in [0, 1]
};

EngineOptions engineOptions(const BenchOptions& options);

/// Reads a scene of the folder `options.scenes` at 720 x 480, times the scale, and one ray per pixel. Its shadows are
/// deep shadow maps at tolerance 0.01, chunked, filtered. An Error names the script that makes a file that is missing.
Scene readBenchScene(const BenchOptions& options, const std::string& file);

/// The same for a file anywhere.
Scene readAnyScene(const BenchOptions& options, const std::string& path);

/// Texels per side of a map at the scale of the run.
int scaledMapSize(const BenchOptions& options, int mapSize);

/// The same scene with maps of this size (before scaling), clusters and memory.
Scene withMaps(const BenchOptions& options, Scene scene, int mapSize, int clusters, const std::string& memory);

/// "256^2" or "4 x 256^2", at the scale of the run.
std::string mapSizeText(const BenchOptions& options, int mapSize, int clusters);

/// A scene with an engine of its own, so that its maps stay while others are measured in turn. Times are wall clock.
class Subject {
 public:
  Subject(const BenchOptions& options, Scene scene);

  /// A frame whose maps were built before. Throws Error if one had to be built.
  double frameMs();
  double frameMs(const std::string& filter);

  /// A frame, whatever it has to build; `camera` from now on.
  double frameMs(const Camera& camera);

  /// Building all maps of all lights, see frame_times.hpp.
  double buildMs();

  /// A frame after all lights were changed by too little to be seen, with all that has to be built for it.
  double movedLightMs();

  /// CPU time of clustering in the last call.
  double clusterMs() const { return engine_.stats().clusterMs; }

  /// Looking up the light of the scene's first light at world points, on the device alone: 0 without event times.
  double lookupMs(const std::vector<glm::vec3>& points);
  std::vector<Transmittance> transmittance(const std::vector<glm::vec3>& points);

  /// From now on 3 x 2 pixels: the same maps as of the whole image, since clusters depend on its aspect ratio alone.
  void shrinkImage();

  Image render() { return engine_.render(scene_); }
  Scene& scene() { return scene_; }
  const FrameStats& stats() const { return engine_.stats(); }
  const DeviceDescription& device() const { return engine_.device(); }

 private:
  Engine engine_;
  Scene scene_;
  bool nudged_ = false;
};

using Subjects = std::vector<std::unique_ptr<Subject>>;

/// Of all maps of all lights.
double nodesMean(const FrameStats& stats);  ///< per texel, over all of them
double nodesMax(const FrameStats& stats);

/// What maps hold, one column for each subject: nodes per texel and memory. `mean` and `most` are the thesis's nodes.
std::vector<Row> mapRows(const Subjects& subjects, const std::vector<double>& mean = {},
                         const std::vector<double>& most = {});

/// Figures of one thing to be measured, always in the same order.
using Measurement = std::function<std::vector<double>()>;

/// Medians of all figures of all measurements, by figure, then by measurement. Each is taken once without counting,
/// then `options.runs` times, all in turn, so that whatever else the machine does hits all of them alike.
std::vector<std::vector<double>> mediansInTurn(const BenchOptions& options,
                                               const std::vector<Measurement>& measurements);

}  // namespace cdsm::cli
