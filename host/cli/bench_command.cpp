// SPDX-License-Identifier: Apache-2.0
// `cdsm bench SUITE`: the tables of the papers, measured here.
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include <cdsm/error.hpp>

#include "bench_suites.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "io/atomic_file.hpp"
#include "scene/range.hpp"
#include "scene_run.hpp"

namespace cdsm::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostRuns = 1000;
constexpr double kLeastScale = 0.01;

struct Suite {
  const char* name;
  const char* what;
  std::vector<Table> (*measure)(const BenchOptions&);
};

constexpr Suite kSuites[] = {
    {"demo", "frame, build and shadow rays against each other", benchDemo},
    {"map-size", "times against the size of maps (Tables 5.1 to 5.4)", benchMapSize},
    {"volume-size", "times and nodes against a volume's resolution (5.5 to 5.7)", benchVolumeSize},
    {"tolerance", "times and nodes against the tolerance (5.8 to 5.10)", benchTolerance},
    {"objects", "times against the number of objects (Figure 5.13)", benchObjects},
    {"chunks", "memory that chunks take and waste (Table 5.11)", benchChunks},
    {"gallery", "frame rates of all scenes, moving camera (Figure 5.14)", benchGallery},
    {"memory", "strategies and formats of nodes, [SCENE...] with [--map-sizes]", benchMemory},
    {"techniques", "frames of all techniques, cached and not (Ropinski's Tables 1 and 2)", benchTechniques},
    {"spheres", "implicit spheres and ambient occlusion on molecules (Krone's Figure 8)", benchSpheres},
    {"clustering", "error of shadows and times, with clusters and without", benchClustering},
    {"query", "points a second from arrays of the host, beside the bare kernel", benchQuery},
    {"stochastic", "stochastic shadows against maps (Weidner's Tables 3 and 4)", benchStochastic},
};

struct CommandOptions : BenchOptions {
  std::string suite;
  std::string json;
  bool quiet = false;
};

const Suite& suiteOf(const std::string& name) {
  std::string known;
  for (const Suite& suite : kSuites) {
    if (name == suite.name) return suite;
    known += (known.empty() ? "" : ", ") + std::string(suite.name);
  }
  throw UsageError("unknown suite '" + name + "', must be one of: " + known);
}

std::string helpOfSuites() {
  std::string text = "What to measure:";
  for (const Suite& suite : kSuites) text += "\n" + std::string(suite.name) + ": " + suite.what;
  return text;
}

DeviceDescription deviceOf(const BenchOptions& options) {
  EngineOptions engine;
  engine.device = options.device;
  return Engine(engine).device();
}

Json resultsJson(const CommandOptions& options, const DeviceDescription& device, const std::vector<Table>& tables) {
  Json list = Json::array();
  for (const Table& table : tables) list.push_back(tableJson(table));
  return {{"suite", options.suite},
          {"device",
           {{"platform", device.platform},
            {"name", device.name},
            {"version", device.version},
            {"compute_units", device.computeUnits}}},
          {"runs", options.runs},
          {"scale", options.scale},
          {"tables", list}};
}

void run(CommandOptions& options) {
  const Suite& suite = suiteOf(options.suite);
  if (options.suite != "memory" && !(options.files.empty() && options.mapSizes.empty()))
    throw UsageError("suite '" + options.suite + "' has its own scenes and sizes of maps, only 'memory' takes others");
  if (!options.json.empty()) io::checkOutputPath(options.json);
  const DeviceDescription device = deviceOf(options);
  std::vector<Table> tables;
  {
    Console console(options.quiet);
    console.setLabel(options.suite + ": ");
    options.progress = [&console](const std::string& step, float done) { console.progress(step, done); };
    tables = suite.measure(options);
  }
  std::cout << "suite " << suite.name << ": medians of " << options.runs << "; " << device.name << ", "
            << device.computeUnits << " cores, " << device.version << '\n';
  for (const Table& table : tables) printTable(std::cout, table);
  if (!options.json.empty()) {
    const Json results = resultsJson(options, device, tables);
    writeText(options.json, results.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  }
}

}  // namespace

void addBenchCommand(CLI::App& app) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand("bench", "Measure the tables of the papers on this machine");
  command->add_option("SUITE", options->suite, helpOfSuites())->required();
  command->add_option("SCENE", options->files, "Suite memory: scenes in place of its own");
  command->add_option("--map-sizes", options->mapSizes, "Suite memory: texels per side of maps, e.g. 512,4096")
      ->delimiter(',')
      ->check(CLI::Range(int(scene::kMapSize.low), int(scene::kMapSize.high)));
  command->add_option("--json", options->json, "Write the figures to this file");
  command->add_option("--device", options->device, "platform:device or part of a device's name [$CDSM_DEVICE]");
  command->add_option("--scenes", options->scenes, "Folder with demo/, bench/ and papers/")->capture_default_str();
  command->add_option("--runs", options->runs, "Runs for each figure, whose median counts")
      ->check(CLI::Range(1, kMostRuns))
      ->capture_default_str();
  command->add_option("--scale", options->scale, "Sides of images and maps times this, to try a suite out")
      ->check(CLI::Range(kLeastScale, 1.0))
      ->capture_default_str();
  command->add_flag("--quiet", options->quiet, "No progress");
  command->final_callback([options] { run(*options); });
}

}  // namespace cdsm::cli
