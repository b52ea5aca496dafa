// SPDX-License-Identifier: Apache-2.0
// What the commands that work on a scene share: their options, the scene, an engine, statistics.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <cdsm/cdsm.hpp>

#include "console.hpp"
#include "device/host_step.hpp"
#include "io/scene_file.hpp"

namespace cdsm::cli {

struct SceneOptions {
  std::string scene;
  std::vector<std::string> settings;  ///< KEY=VALUE
  std::string device;
  std::string fetch = "auto";
  std::string stats;  ///< a file's name, or empty
  std::string trace;  ///< likewise
  bool quiet = false;
};

/// Adds SCENE, --set, --device, --fetch, --stats, --trace and --quiet. `options` must live until the command has run.
void addSceneOptions(CLI::App& command, SceneOptions& options);

/// Throws UsageError if two of the paths lead to the same file: a result must replace neither an input nor another
/// result. Empty paths and "-" stand for no file.
void requireDistinctFiles(const std::vector<std::string>& paths);

/// Writes the whole file or leaves what was there.
void writeText(const std::string& path, const std::string& text);

/// What happened when, for --trace; keeps nothing unless it is wanted.
class TraceLog {
 public:
  explicit TraceLog(bool wanted);
  TraceLog(const TraceLog&) = delete;
  TraceLog& operator=(const TraceLog&) = delete;

  const TraceSink& sink() const { return sink_; }
  /// The file's text.
  std::string json(const DeviceDescription& device) const;
  /// What `make` returns, as a step of the trace.
  template <class Make>
  auto during(const std::string& step, const Make& make) const -> decltype(make()) {
    const device::HostStep traced(sink_, step);
    return make();
  }

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::vector<TraceEvent> events_;
  TraceSink sink_;
};

/// A scene that was read and the engine to work on it, one for all frames. Making one checks the paths of statistics
/// and trace before all else.
class SceneRun {
 public:
  explicit SceneRun(const SceneOptions& options, int frame = 0);
  SceneRun(const SceneRun&) = delete;
  SceneRun& operator=(const SceneRun&) = delete;

  /// Of the frame at hand.
  const Scene& scene() const { return scene_; }
  Engine& engine() { return engine_; }

  /// Goes on to another frame; `label` is what progress begins with.
  void goTo(int frame, const std::string& label);

  /// Passes on what the engine's last call had to warn of.
  void warn();

  /// A step of the command for the trace, as long as it lives.
  device::HostStep step(const std::string& name) const { return {trace_.sink(), name}; }

  /// Writes statistics and trace, as far as they are asked for: of the engine's last call, or of `frames` and with the
  /// settings of the last one.
  void writeStats() const { writeStats({engine_.stats()}); }
  void writeStats(const std::vector<FrameStats>& frames) const;

 private:
  std::string statsPath_, tracePath_;
  TraceLog trace_;
  Console console_;
  io::SceneReader reader_;
  int frame_;
  Scene scene_;
  Engine engine_;
};

}  // namespace cdsm::cli
