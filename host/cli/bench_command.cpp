// SPDX-License-Identifier: Apache-2.0
// cdsm bench SUITE: the tables of the papers, measured here.
#include <fstream>
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "bench_demo.hpp"
#include "commands.hpp"
#include "io/atomic_file.hpp"

namespace cdsm::cli {

namespace {

struct BenchOptions {
  std::string suite;
  DemoBenchOptions demo;
  std::string json;
};

void run(const BenchOptions& options) {
  if (options.suite != "demo") throw UsageError("the suite '" + options.suite + "' is not supported yet; known: demo");
  if (!options.json.empty()) io::checkOutputPath(options.json);
  const nlohmann::ordered_json results = benchDemo(options.demo, std::cout);
  if (options.json.empty()) return;
  io::AtomicFile file(options.json);
  std::ofstream(file.temporaryPath()) << results.dump(2) << '\n';
  file.commit();
}

}  // namespace

void addBenchCommand(CLI::App& app) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = app.add_subcommand("bench", "measure the tables of the papers on this machine");
  command->add_option("SUITE", options->suite, "demo: frame, build and shadow rays against each other")->required();
  command->add_option("--json", options->json, "write the figures to this file");
  command->add_option("--device", options->demo.device, "platform:device or part of a device's name");
  command->add_option("--scenes", options->demo.scenes, "folder with demo/ and bench/")->capture_default_str();
  command->add_option("--runs", options->demo.runs, "runs per figure, the median counts")->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace cdsm::cli
