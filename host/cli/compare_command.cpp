// SPDX-License-Identifier: Apache-2.0
// `cdsm compare SCENE -o FOLDER`: every shadow technique on one scene, with errors, times and memory.
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <cdsm/error.hpp>

#include "bench_tables.hpp"
#include "commands.hpp"
#include "comparison.hpp"
#include "frame_times.hpp"
#include "io/atomic_folder.hpp"
#include "io/data_uri.hpp"
#include "io/image_file.hpp"
#include "scene_run.hpp"

namespace cdsm::cli {
namespace {

constexpr int kMostRuns = 1000;
constexpr double kPatienceMs = 10000.0;  // after which a technique is not timed once more

struct CompareOptions : SceneOptions {
  std::string folder;
  int runs = 3;
};

/// What variants are rendered with and held against.
struct Bench {
  const CompareOptions& options;
  SceneRun& run;
  io::AtomicFolder& folder;
  Image reference;
  std::vector<FrameStats> stats;  ///< of each picture
};

/// As many times as asked for, unless that takes too long.
template <class Measure>
std::vector<double> repeated(const CompareOptions& options, const Measure& measureMs) {
  std::vector<double> times;
  double sum = 0.0;
  do {
    times.push_back(measureMs());
    sum += times.back();
  } while (int(times.size()) < options.runs && sum < kPatienceMs);
  return times;
}

/// `firstMs`: of the frame that came before, which also built what there is to build.
void takeTimes(Bench& bench, Scene scene, double firstMs, VariantResult& result) {
  Engine& engine = bench.run.engine();
  const bool builds = result.bytes > 0;
  std::vector<double> frames{firstMs};
  if (builds || firstMs < kPatienceMs) frames = repeated(bench.options, [&] { return renderMs(engine, scene); });
  result.frames = int(frames.size());
  result.frameMs = median(frames);
  bool nudged = false;
  if (builds) result.buildMs = median(repeated(bench.options, [&] { return buildMs(engine, scene, nudged); }));
}

void writePictures(Bench& bench, const Image& image, const ShadowVariant& variant) {
  writeImage(bench.folder.file(pictureName(variant)), image);
  if (variant.name == referenceVariant().name) return;
  writeImage(bench.folder.file(differenceName(variant)),
             io::differencePicture(image, bench.reference, kDifferenceFactor));
}

void measure(Bench& bench, VariantResult& result) {
  Scene scene = bench.run.scene();
  scene.shadows = result.variant.applied(scene.shadows);
  const auto begun = std::chrono::steady_clock::now();
  const Image image = bench.run.engine().render(scene);
  const std::chrono::duration<double, std::milli> first = std::chrono::steady_clock::now() - begun;
  bench.run.warn();
  const FrameStats stats = bench.run.engine().stats();
  bench.stats.push_back(stats);
  result.warnings = stats.warnings;
  result.maps = mapCount(stats);
  result.bytes = stats.memory.bytesReserved + (stats.cache ? stats.cache->bytes : 0);
  if (bench.reference.pixels.empty()) bench.reference = image;
  result.difference = io::differenceOf(image, bench.reference);
  writePictures(bench, image, result.variant);
  takeTimes(bench, scene, first.count(), result);
}

/// What a technique cannot do is said in the place of its picture; without the reference there is nothing to compare.
VariantResult measured(Bench& bench, const ShadowVariant& variant) {
  VariantResult result;
  result.variant = variant;
  bench.run.goTo(0, variant.name + ": ");
  const device::HostStep step = bench.run.step(variant.name);
  try {
    measure(bench, result);
  } catch (const Error& error) {
    if (bench.reference.pixels.empty()) throw;
    result.reason = error.what();
  }
  return result;
}

void writeComparison(const Comparison& comparison, io::AtomicFolder& folder) {
  std::map<std::string, std::string> pictures;
  const auto embed = [&](const std::string& name) { pictures[name] = io::pngDataUri(folder.file(name)); };
  for (const VariantResult& result : comparison.results) {
    if (!result.reason.empty()) continue;
    embed(pictureName(result.variant));
    if (result.variant.name != referenceVariant().name) embed(differenceName(result.variant));
  }
  writeText(folder.file("compare.json"), comparisonJson(comparison));
  writeText(folder.file("index.html"), comparisonPage(comparison, pictures));
}

void compare(const CompareOptions& options) {
  requireDistinctFiles({options.scene, options.stats, options.trace, options.folder});
  io::AtomicFolder folder(options.folder, comparisonFiles());
  SceneRun run(options);
  Bench bench{options, run, folder, {}, {}};
  Comparison comparison{options.scene,     options.settings,    run.engine().device(),
                        run.scene().image, run.scene().shadows, {}};
  for (const ShadowVariant& variant : shadowVariants()) comparison.results.push_back(measured(bench, variant));
  writeComparison(comparison, folder);
  folder.commit();
  run.writeStats(bench.stats);
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("compare", "Every shadow technique on one scene: images, errors, times and memory on a page");
  auto options = std::make_shared<CompareOptions>();
  addSceneOptions(*command, *options);
  command
      ->add_option("-o", options->folder,
                   "Folder to write: index.html, compare.json and the pictures; an earlier result is replaced")
      ->required()
      ->type_name("FOLDER");
  command->add_option("--runs", options->runs, "Frames timed for each technique, fewer where they take long [3]")
      ->check(CLI::Range(1, kMostRuns));
  command->final_callback([options] { compare(*options); });
}

}  // namespace cdsm::cli
