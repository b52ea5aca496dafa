// SPDX-License-Identifier: Apache-2.0
#include "bench_demo.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iomanip>

#include <cdsm/cdsm.hpp>

#include "engine/trilinear_rate.hpp"
#include "io/scene_file.hpp"

namespace cdsm::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Median wall clock of `runs` calls in milliseconds, after one that is not counted.
double medianMs(int runs, const std::function<void(int)>& call) {
  std::vector<double> times;
  for (int i = 0; i <= runs; ++i) {
    const auto begun = std::chrono::steady_clock::now();
    call(i);
    if (i > 0)
      times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

/// One light, 720 x 480, one ray per pixel, a 512^2 map at tolerance 0.01 with filtered lookups.
Scene benchScene(const std::string& path) {
  Scene scene = io::readScene(path);
  scene.lights.resize(1);
  scene.image.width = 720;
  scene.image.height = 480;
  scene.image.supersampling = 1;
  scene.shadows = ShadowSettings{};
  return scene;
}

/// The same scene, but its map has to be built again.
Scene nudged(const Scene& scene, int run) {
  Scene other = scene;
  other.lights[0].cutoff *= 1.0f + 1e-5f * float(run + 1);
  return other;
}

/// One frame with shadow rays, which takes too long for medians; kernels are compiled with a tiny image before.
double shadowRaysMs(Engine& engine, Scene scene) {
  scene.shadows.technique = "shadow-rays";
  Scene tiny = scene;
  tiny.image.width = tiny.image.height = 8;
  engine.render(tiny);
  engine.render(scene);
  return engine.stats().totalMs;
}

/// Times of one scene in milliseconds.
Json measureScene(Engine& engine, const Scene& scene, int runs, double rate) {
  Scene plain = scene;
  plain.shadows.technique = "none";
  Json row;
  const double none = medianMs(runs, [&](int) { engine.render(plain); });
  const double frame = medianMs(runs, [&](int) { engine.render(scene); });
  const FrameStats stats = engine.stats();
  const double build =
      medianMs(runs, [&](int run) { engine.transmittance(nudged(scene, run), scene.lights[0].name, {}); });
  const double marched = shadowRaysMs(engine, scene);
  row["ms"] = {{"none", none}, {"frame", frame}, {"build", build}, {"shadow_rays", marched}};
  row["shaded_samples"] = stats.shadedSamples;
  row["frame_over_none"] = frame / none;
  row["trilinear_per_shaded_sample"] = frame * rate * 1000.0 / double(std::max<std::uint64_t>(stats.shadedSamples, 1));
  row["build_over_none"] = build / none;
  row["shadow_rays_over_frame_and_build"] = marched / (frame + build);
  row["bytes_per_node"] = stats.memory.bytesPerNode;
  row["bytes_reserved"] = stats.memory.bytesReserved;
  row["nodes_mean"] = stats.lights[0].maps[0].nodesMean;
  row["nodes_max"] = stats.lights[0].maps[0].nodesMax;
  return row;
}

void printRow(std::ostream& out, const std::string& what, const Json& results, const char* key) {
  out << std::left << std::setw(52) << what << std::right << std::fixed << std::setprecision(3);
  for (const auto& scene : results["scenes"]) out << std::setw(12) << scene[key].get<double>();
  out << '\n';
}

void printTable(std::ostream& out, const Json& results) {
  out << "device: " << results["device"].get<std::string>() << "\ntrilinear samples: " << std::fixed
      << std::setprecision(0) << results["million_trilinear_per_second"].get<double>() << " million / s\n\n"
      << std::setw(52) << "";
  for (const auto& scene : results["scenes"].items()) out << std::setw(12) << scene.key();
  out << '\n';
  printRow(out, "frame with shadows / frame without", results, "frame_over_none");
  printRow(out, "trilinear samples per shaded sample", results, "trilinear_per_shaded_sample");
  printRow(out, "building a 512^2 map / frame without shadows", results, "build_over_none");
  printRow(out, "frame with shadow rays / (frame + map)", results, "shadow_rays_over_frame_and_build");
  printRow(out, "bytes per node", results, "bytes_per_node");
  printRow(out, "nodes per texel, mean", results, "nodes_mean");
}

}  // namespace

Json benchDemo(const DemoBenchOptions& options, std::ostream& out) {
  EngineOptions engineOptions;
  engineOptions.device = options.device;
  Engine engine(engineOptions);
  Json results;
  results["device"] = engine.device().name;
  const double rate = engine::trilinearRate(options.device, options.runs);
  results["million_trilinear_per_second"] = rate;
  const std::pair<const char*, const char*> scenes[] = {
      {"demo", "/demo/demo.toml"}, {"smoke", "/bench/smoke.toml"}, {"sparse", "/bench/sparse.toml"}};
  for (const auto& [name, file] : scenes)
    results["scenes"][name] = measureScene(engine, benchScene(options.scenes + file), options.runs, rate);
  printTable(out, results);
  return results;
}

}  // namespace cdsm::cli
