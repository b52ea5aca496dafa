// SPDX-License-Identifier: Apache-2.0
// `cdsm render SCENE [-o IMAGE] [--frames FIRST:LAST] [--view NAME]`: the camera's image of a scene, or those of an
// animation; debug pictures in their place.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cdsm/error.hpp>

#include "commands.hpp"
#include "engine/view_names.hpp"
#include "io/frame_numbers.hpp"
#include "io/image_file.hpp"
#include "scene_run.hpp"

namespace cdsm::cli {
namespace {

struct RenderOptions : SceneOptions {
  std::string image;
  std::optional<std::string> frames;
  std::optional<std::string> view;
  std::optional<std::string> light;
};

/// Images lie in the current folder unless told otherwise, not in the scene's, which may be read-only.
std::string nameOf(const std::string& scene) { return std::filesystem::path(scene).stem().string(); }

io::FramePattern patternOf(const RenderOptions& options) {
  return options.image.empty() ? io::FramePattern(nameOf(options.scene), ".png") : io::FramePattern(options.image);
}

/// One name for each frame, in their order.
std::vector<std::string> imagesOf(const RenderOptions& options, const io::FrameRange& frames) {
  const io::FramePattern pattern = patternOf(options);
  if (frames.count() > 1 && !pattern.isNumbered()) {
    throw UsageError("'" + options.image + "' is the name of one image, must have %d or %04d for the frame's number");
  }
  std::vector<std::string> images;
  for (int frame = frames.first; frame <= frames.last; ++frame) images.push_back(pattern.path(frame));
  return images;
}

void checkFiles(const SceneOptions& options, const std::vector<std::string>& images) {
  for (const std::string& image : images) io::checkImagePath(image);
  std::vector<std::string> files = images;
  files.insert(files.end(), {options.scene, options.stats, options.trace});
  requireDistinctFiles(files);
}

/// The scene's picture or the debug picture asked for.
Image renderWith(const RenderOptions& options, SceneRun& run) {
  if (!options.view) return run.engine().render(run.scene());
  const std::vector<std::string>& names = engine::viewNames();
  const auto view = DebugView(std::find(names.begin(), names.end(), *options.view) - names.begin());
  return run.engine().render(run.scene(), {view, options.light});
}

/// Writes that picture. What a debug picture's scale ends at is said on standard output.
void renderTo(const std::string& path, const RenderOptions& options, SceneRun& run) {
  const Image image = renderWith(options, run);
  {
    const device::HostStep step = run.step("write image");
    writeImage(path, image);
  }
  const std::optional<ViewStats>& view = run.engine().stats().view;
  if (view && view->scale) std::cout << path << ": " << view->name << " from 0 to " << *view->scale << std::endl;
}

void renderImage(const RenderOptions& options) {
  const std::string image = options.image.empty() ? nameOf(options.scene) + ".png" : options.image;
  checkFiles(options, {image});
  SceneRun run(options);
  renderTo(image, options, run);
  run.warn();
  run.writeStats();
}

void renderFrames(const RenderOptions& options, const io::FrameRange& frames, const std::vector<std::string>& images) {
  checkFiles(options, images);
  SceneRun run(options, frames.first);
  std::vector<FrameStats> stats;
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    const device::HostStep step = run.step("frame " + std::to_string(frame));
    run.goTo(frame, "frame " + std::to_string(frame) + " of " + *options.frames + ": ");
    renderTo(images[frame - frames.first], options, run);
    run.warn();
    stats.push_back(run.engine().stats());
    stats.back().frame = frame;
  }
  run.writeStats(stats);
}

void render(const RenderOptions& options) {
  if (!options.frames) return renderImage(options);
  io::FrameRange frames;
  std::vector<std::string> images;
  try {
    frames = io::parseFrames(*options.frames);
    images = imagesOf(options, frames);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  renderFrames(options, frames, images);
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to an image, or an animation to images");
  auto options = std::make_shared<RenderOptions>();
  addSceneOptions(*command, *options);
  command->add_option("-o", options->image,
                      "Image to write, .png or .exr; with --frames one %d or %04d stands for the frame's number "
                      "[SCENE.png, SCENE_%04d.png]");
  command
      ->add_option("--frames", options->frames,
                   "Frames of an animation, from 0 on, in one process [the scene at frame 0]")
      ->type_name("FIRST:LAST");
  CLI::Option* view =
      command
          ->add_option(
              "--view", options->view,
              "A picture of internals instead: clusters of casters, nodes of the maps' texels, layers or steps "
              "along camera rays, texels of the maps")
          ->check(CLI::IsMember(engine::viewNames()))
          ->type_name("NAME");
  command->add_option("--light", options->light, "The light whose maps --view shows [the scene's first]")
      ->needs(view)
      ->type_name("NAME");
  command->final_callback([options] { render(*options); });
}

}  // namespace cdsm::cli
