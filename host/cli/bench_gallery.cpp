// SPDX-License-Identifier: Apache-2.0
// Suite "gallery" [Knecht 2011, Figure 5.14]: frame rates while the camera goes around what it looks at, a degree a
// frame. Maps that the way makes necessary are built on the way. The thesis shows its rates in a figure only.
#include "bench_camera_path.hpp"
#include "bench_scenes.hpp"
#include "bench_suites.hpp"

namespace cdsm::cli {
namespace {

constexpr int kFrames = 10;
constexpr float kDegreesPerFrame = 1.0f;

}  // namespace

std::vector<Table> benchGallery(const BenchOptions& options) {
  Row lights = plainRow("lights"), maps = plainRow("maps"), built = plainRow("maps built in a frame, average");
  Row typical = plainRow("frame, median", "ms"), rate = plainRow("frames per second, average");
  forEachPaperScene(options, [&](Subject& subject) {
    const Camera start = subject.scene().camera;
    subject.frameMs(start);
    lights.ours.push_back(double(subject.scene().lights.size()));
    maps.ours.push_back(double(mapCount(subject.stats())));
    std::vector<double> times;
    double sum = 0.0, count = 0.0;
    for (int frame = 1; frame <= kFrames; ++frame) {
      times.push_back(subject.frameMs(turned(start, kDegreesPerFrame * float(frame))));
      sum += times.back();
      count += double(builtMaps(subject.stats()));
    }
    typical.ours.push_back(median(times));
    rate.ours.push_back(1000.0 * kFrames / sum);
    built.ours.push_back(count / kFrames);
  });
  return {{"gallery",
           "Figure 5.14: " + mapSizeText(options, 256, 4) + " for each light, " + std::to_string(kFrames) +
               " frames of a camera that moves",
           "scene",
           paperColumns(),
           {rate, typical, lights, maps, built}}};
}

}  // namespace cdsm::cli
