// SPDX-License-Identifier: Apache-2.0
#include "bench_scenes.hpp"

namespace cdsm::cli {

const std::vector<PaperScene>& paperScenes() {
  static const std::vector<PaperScene> scenes = {
      {"smoking car", "papers/smoking-car/scene.toml"}, {"fog, car", "papers/fog-car/scene.toml"},
      {"two smokes", "papers/two-smokes/scene.toml"},   {"teapot, cup", "papers/teapot-cup/scene.toml"},
      {"park a", "papers/clustering/camera_a.toml"},    {"park b", "papers/clustering/camera_b.toml"},
      {"park c", "papers/clustering/camera_c.toml"},    {"filtering", "papers/filtering/bilinear.toml"},
      {"X-ray", "papers/xray/overview.toml"},           {"X-ray, near", "papers/xray/closeup.toml"},
      {"1 teacup", "papers/teacups/teacups_01.toml"},   {"24 teacups", "papers/teacups/teacups_24.toml"},
  };
  return scenes;
}

std::vector<std::string> paperColumns() {
  std::vector<std::string> columns;
  for (const PaperScene& scene : paperScenes()) columns.push_back(scene.name);
  return columns;
}

void forEachPaperScene(const BenchOptions& options, const std::function<void(Subject&)>& visit) {
  const std::vector<PaperScene>& scenes = paperScenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (options.progress) options.progress(scenes[i].name, float(i) / float(scenes.size()));
    Subject subject(options, withMaps(options, readBenchScene(options, scenes[i].file), 256, 4, "chunked"));
    visit(subject);
  }
}

}  // namespace cdsm::cli
