// SPDX-License-Identifier: Apache-2.0
// `cdsm render SCENE [-o IMAGE]`: the camera's image of a scene.
#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "io/image_file.hpp"
#include "scene_run.hpp"

namespace cdsm::cli {
namespace {

struct RenderOptions : SceneOptions {
  std::string image;
  std::string frames;
};

/// In the current folder, not in the scene's, which may be read-only.
std::string defaultImage(const std::string& scene) { return std::filesystem::path(scene).stem().string() + ".png"; }

void render(const RenderOptions& options) {
  if (!options.frames.empty()) throw UsageError("'--frames' is not supported yet");
  const std::string image = options.image.empty() ? defaultImage(options.scene) : options.image;
  io::checkImagePath(image);
  requireDistinctFiles({options.scene, image, options.stats});
  SceneRun run(options);
  io::writeImage(image, run.engine().render(run.scene()));
  run.writeStats();
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to an image");
  auto options = std::make_shared<RenderOptions>();
  addSceneOptions(*command, *options);
  command->add_option("-o", options->image, "Image to write, .png or .exr [SCENE's name with .png]");
  command->add_option("--frames", options->frames, "Animation, FIRST:LAST: not supported yet");
  command->final_callback([options] { render(*options); });
}

}  // namespace cdsm::cli
