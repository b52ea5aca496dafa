// SPDX-License-Identifier: Apache-2.0
// `cdsm transmittance SCENE --light NAME --points P.csv [-o OUT.csv]`: how much of a light reaches given points.
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "io/atomic_file.hpp"
#include "io/points_file.hpp"
#include "scene_run.hpp"

namespace cdsm::cli {
namespace {

constexpr const char* kStandardOutput = "-";

struct TransmittanceOptions : SceneOptions {
  std::string light;
  std::string points;
  std::string output = kStandardOutput;
};

void answer(const TransmittanceOptions& options) {
  if (options.output != kStandardOutput) io::checkOutputPath(options.output);
  requireDistinctFiles({options.scene, options.points, options.output, options.stats, options.trace});
  const std::vector<glm::vec3> points = io::readPoints(options.points);
  SceneRun run(options);
  const std::vector<Transmittance> answers = run.engine().transmittance(run.scene(), options.light, points);
  {
    const device::HostStep step = run.step("write answers");
    const bool colored = run.scene().shadows.transmittance == "rgb";
    io::writeTransmittances(options.output, points, answers,
                            colored ? io::LightColumns::Colors : io::LightColumns::Transmittance);
  }
  run.warn();
  run.writeStats();
}

}  // namespace

void addTransmittanceCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("transmittance", "Transmittance from a light to points, without rendering");
  auto options = std::make_shared<TransmittanceOptions>();
  addSceneOptions(*command, *options);
  command->add_option("--light", options->light, "Name of the light")->required();
  command->add_option("--points", options->points, "World points: CSV with the header x,y,z")->required();
  command->add_option("-o", options->output,
                      "CSV to write: x,y,z,lit,transmittance, or x,y,z,lit,r,g,b if "
                      "shadows.transmittance is rgb [standard output]");
  command->final_callback([options] { answer(*options); });
}

}  // namespace cdsm::cli
