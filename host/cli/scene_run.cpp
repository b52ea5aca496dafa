// SPDX-License-Identifier: Apache-2.0
// Options, scene and engine of a command, in the order in which they can fail cheapest.
#include "scene_run.hpp"

#include <filesystem>
#include <fstream>
#include <set>

#include <cdsm/error.hpp>

#include "commands.hpp"
#include "engine/stats_json.hpp"
#include "engine/trace_json.hpp"
#include "io/atomic_file.hpp"

namespace cdsm::cli {
namespace {

/// The paths that can be checked are checked before the scene is read.
std::string checkedPath(const std::string& path) {
  if (!path.empty()) io::checkOutputPath(path);
  return path;
}

EngineOptions engineOptions(const SceneOptions& options, Console& console, const TraceSink& trace) {
  EngineOptions engine;
  engine.device = options.device;
  engine.fetch = options.fetch;
  engine.trace = trace;
  engine.progress = [&console](const std::string& step, float done) { console.progress(step, done); };
  return engine;
}

std::string settingProblem(const std::string& setting) {
  return setting.find('=') == std::string::npos ? "'" + setting + "' must be KEY=VALUE" : "";
}

}  // namespace

void writeText(const std::string& path, const std::string& text) {
  io::AtomicFile file(path);
  std::ofstream stream(file.temporaryPath(), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw Error(Location{path}, "cannot be written, must be on a disk with space");
  file.commit();
}

void addSceneOptions(CLI::App& command, SceneOptions& options) {
  command.add_option("SCENE", options.scene, "Scene file (TOML)")->required();
  command.add_option("--set", options.settings, "Change a scene key, such as shadows.memory=atlas; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE")
      ->check(CLI::Validator(settingProblem, ""));
  command.add_option("--device", options.device,
                     "platform:device as 'cdsm devices' numbers them, or part of a name [$CDSM_DEVICE, first usable]");
  command.add_option("--fetch", options.fetch, "How volumes and maps are read [auto]")
      ->check(CLI::IsMember({"auto", "buffer", "image"}));
  command.add_option("--stats", options.stats, "Write times and memory as JSON");
  command
      .add_option("--trace", options.trace,
                  "Write when each kernel, transfer and host step ran, for Perfetto or Chrome")
      ->type_name("FILE.json");
  command.add_flag("--quiet", options.quiet, "No progress");
}

void requireDistinctFiles(const std::vector<std::string>& paths) {
  std::set<std::filesystem::path> files;
  for (const std::string& path : paths) {
    if (path.empty() || path == "-") continue;
    std::error_code failed;
    const std::filesystem::path absolute = std::filesystem::absolute(path, failed);
    const std::filesystem::path file = std::filesystem::weakly_canonical(absolute, failed);
    if (!files.insert(failed ? absolute : file).second)
      throw UsageError("'" + path + "' is named twice, must be different files for inputs and results");
  }
}

TraceLog::TraceLog(bool wanted) {
  if (wanted) sink_ = [this](const TraceEvent& event) { events_.push_back(event); };
}

std::string TraceLog::json(const DeviceDescription& device) const { return engine::traceJson(device, events_, begun_); }

SceneRun::SceneRun(const SceneOptions& options, int frame)
    : statsPath_(checkedPath(options.stats)),
      tracePath_(checkedPath(options.trace)),
      trace_(!tracePath_.empty()),
      console_(options.quiet),
      reader_(options.scene, options.settings),
      frame_(frame),
      scene_(trace_.during("read scene", [&] { return reader_.frame(frame); })),
      engine_(trace_.during("open device", [&] { return Engine(engineOptions(options, console_, trace_.sink())); })) {}

void SceneRun::goTo(int frame, const std::string& label) {
  console_.setLabel(label);
  if (frame == frame_) return;
  scene_ = trace_.during("read scene", [&] { return reader_.frame(frame); });
  frame_ = frame;
}

void SceneRun::warn() {
  for (const std::string& warning : engine_.stats().warnings) console_.warn(warning);
}

void SceneRun::writeStats(const std::vector<FrameStats>& frames) const {
  if (!statsPath_.empty()) writeText(statsPath_, engine::statsJson(engine_.device(), scene_.shadows, frames));
  if (!tracePath_.empty()) writeText(tracePath_, trace_.json(engine_.device()));
}

}  // namespace cdsm::cli
