// SPDX-License-Identifier: Apache-2.0
// Suite "clustering": what clusters gain (error of shadows against shadow rays, as many texels) and cost (frames, the
// CPU's time, maps built along a camera's path).
#include <iterator>

#include "bench_camera_path.hpp"
#include "bench_suites.hpp"
#include "io/image_difference.hpp"

namespace cdsm::cli {
namespace {

const char* const kCameras[] = {"a", "b", "c"};
constexpr int kPathFrames = 60;
constexpr float kPathDegrees = 0.5f;               // per frame
constexpr double kThesisFrameRatio = 72.0 / 53.0;  // [Knecht 2011, Tables 5.2 and 5.1, 512^2 filtered]
constexpr double kWantedFrameRatio = 1.15, kWantedClusterMs = 1.0;

Scene park(const BenchOptions& options, const std::string& camera) {
  return readBenchScene(options, "papers/clustering/camera_" + camera + ".toml");
}

Row ratioRow(const char* label, const Row& of, const Row& to, std::vector<double> wanted) {
  Row row = plainRow(label, "", std::move(wanted));
  for (std::size_t i = 0; i < of.ours.size(); ++i) row.ours.push_back(of.ours[i] / to.ours[i]);
  return row;
}

Table errorTable(const BenchOptions& options) {
  Row one = plainRow("one map of " + mapSizeText(options, 1024, 1) + ", RMS");
  Row four = plainRow("clusters, " + mapSizeText(options, 512, 4) + ", RMS");
  for (const char* camera : kCameras) {
    const Scene scene = park(options, camera);
    Scene rays = scene;
    rays.shadows.technique = "shadow-rays";
    if (options.progress) options.progress("shadow rays, camera " + std::string(camera), 0.0f);
    const Image truth = Subject(options, rays).render();
    Subject subject(options, withMaps(options, scene, 1024, 1, "chunked"));
    one.ours.push_back(io::rmsDifference(subject.render(), truth));
    subject.scene() = withMaps(options, scene, 512, 4, "chunked");
    four.ours.push_back(io::rmsDifference(subject.render(), truth));
  }
  return {"error",
          "Error of shadows: difference to shadow rays, as many texels",
          "camera",
          {kCameras, kCameras + std::size(kCameras)},
          {one, four, ratioRow("clusters / one map", four, one, {0.5, 0.5, 1.0})}};
}

Table frameTable(const BenchOptions& options) {
  Subjects subjects;
  std::vector<Measurement> measurements;
  for (const int clusters : {1, 4}) {
    for (const char* camera : kCameras) {
      subjects.push_back(
          std::make_unique<Subject>(options, withMaps(options, park(options, camera), 512, clusters, "chunked")));
      measurements.push_back([subject = subjects.back().get()] { return std::vector<double>{subject->frameMs()}; });
    }
  }
  const std::vector<double> times = mediansInTurn(options, measurements)[0];
  Row one = plainRow("one map", "ms"), four = plainRow("four clusters", "ms");
  const auto middle = times.begin() + std::ptrdiff_t(std::size(kCameras));
  one.ours.assign(times.begin(), middle);
  four.ours.assign(middle, times.end());
  Row ratio =
      ratioRow("four clusters / one map", four, one, std::vector<double>(std::size(kCameras), kWantedFrameRatio));
  ratio.thesis = {kThesisFrameRatio, kThesisFrameRatio, kThesisFrameRatio};
  return {"frame",
          "Frame, filtered, maps of " + mapSizeText(options, 512, 1) + " built before",
          "camera",
          {kCameras, kCameras + std::size(kCameras)},
          {one, four, ratio}};
}

/// The first teacup and its steam, side by side until there are so many objects that cast.
Scene manyObjects(const BenchOptions& options, int objects) {
  Scene scene = withMaps(options, readBenchScene(options, "papers/teacups/teacups_01.toml"), 64, 4, "chunked");
  const Mesh cup = scene.meshes.back();
  const Volume steam = scene.volumes.back();
  scene.meshes.pop_back();
  scene.volumes.clear();
  constexpr int kPerRow = 5;
  constexpr float kGap = 1.35f;
  for (int i = 0; 2 * i < objects; ++i) {
    const glm::vec3 moved(kGap * float(i % kPerRow - kPerRow / 2), 0.0f, kGap * float(i / kPerRow - kPerRow / 2));
    scene.meshes.push_back(cup);
    scene.volumes.push_back(steam);
    for (glm::mat4* matrix : {&scene.meshes.back().worldFromObject, &scene.volumes.back().worldFromObject})
      (*matrix)[3] += glm::vec4(moved, 0.0f);
    scene.meshes.back().name += " and " + std::to_string(i);
    scene.volumes.back().name += " and " + std::to_string(i);
  }
  return scene;
}

Table cpuTable(const BenchOptions& options) {
  Table table{"cpu", "Clustering on the CPU: teacups and their steam, one light, four clusters", "objects", {}, {}};
  std::vector<Subject> subjects;
  std::vector<Measurement> measurements;
  for (const int objects : {10, 30, 50}) {
    table.columns.push_back(std::to_string(objects));
    subjects.emplace_back(options, manyObjects(options, objects));
  }
  for (Subject& subject : subjects) {
    subject.shrinkImage();
    measurements.push_back([&subject] {
      subject.render();
      return std::vector<double>{subject.clusterMs()};
    });
  }
  Row row = plainRow("clustering", "ms");
  row.ours = mediansInTurn(options, measurements)[0];
  row.wanted.assign(row.ours.size(), kWantedClusterMs);
  table.rows = {row};
  return table;
}

Table pathTable(const BenchOptions& options) {
  Row maps = plainRow("maps"), frames = plainRow("frames that built maps"), built = plainRow("maps built");
  for (const auto& [clusters, stable] : {std::pair(1, false), {4, false}, {4, true}}) {
    Scene scene = withMaps(options, park(options, "a"), 512, clusters, "chunked");
    scene.shadows.stable = stable;
    Subject subject(options, scene);
    subject.shrinkImage();
    double frameCount = 0.0, mapsBuilt = 0.0;
    for (int frame = 0; frame < kPathFrames; ++frame) {
      if (options.progress) options.progress("camera path", float(frame) / kPathFrames);
      subject.frameMs(turned(scene.camera, kPathDegrees * float(frame)));
      frameCount += builtMaps(subject.stats()) > 0;
      mapsBuilt += double(builtMaps(subject.stats()));
    }
    maps.ours.push_back(double(mapCount(subject.stats())));
    frames.ours.push_back(frameCount);
    built.ours.push_back(mapsBuilt);
  }
  frames.wanted = {1.0, 1.0, 1.0};
  return {"path",
          "A camera's path of " + std::to_string(kPathFrames) + " frames, half a degree each",
          "clusters",
          {"1", "4", "4, stable"},
          {maps, built, frames}};
}

}  // namespace

std::vector<Table> benchClustering(const BenchOptions& options) {
  return {errorTable(options), frameTable(options), cpuTable(options), pathTable(options)};
}

}  // namespace cdsm::cli
