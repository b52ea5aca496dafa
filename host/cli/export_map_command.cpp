// SPDX-License-Identifier: Apache-2.0
// `cdsm export-map SCENE --light NAME -o MAP.exr [--tiled]`: a light's deep shadow maps for other people's tools.
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "io/map_file.hpp"
#include "scene_run.hpp"

namespace cdsm::cli {
namespace {

struct ExportMapOptions : SceneOptions {
  std::string light;
  std::string file;
  bool tiled = false;
};

void writeMaps(const SceneRun& run, const ExportMapOptions& options, const std::vector<LightMap>& maps) {
  const device::HostStep step = run.step("write maps");
  for (const Light& light : run.scene().lights) {
    if (light.name != options.light) continue;
    io::writeLightMaps(options.file, light, maps,
                       options.tiled ? io::MapFileLayout::Tiles : io::MapFileLayout::Scanlines);
  }
}

void exportMap(const ExportMapOptions& options) {
  io::checkMapPath(options.file);
  requireDistinctFiles({options.scene, options.file, options.stats, options.trace});
  SceneRun run(options);
  const std::vector<LightMap> maps = run.engine().lightMaps(run.scene(), options.light);
  writeMaps(run, options, maps);
  run.warn();
  run.writeStats();
}

}  // namespace

void addExportMapCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export-map", "Write a light's deep shadow maps as a deep EXR file");
  auto options = std::make_shared<ExportMapOptions>();
  addSceneOptions(*command, *options);
  command->add_option("--light", options->light, "Name of the light")->required();
  command
      ->add_option("-o", options->file,
                   "Deep EXR to write: one part per map, channels A, Z, ZBack "
                   "(and AR, AG, AB if shadows.transmittance is rgb)")
      ->required();
  command->add_flag("--tiled", options->tiled, "Tiles of 64 x 64 texels in place of scanlines");
  command->final_callback([options] { exportMap(*options); });
}

}  // namespace cdsm::cli
