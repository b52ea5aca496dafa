// SPDX-License-Identifier: Apache-2.0
// Suite "volume-size" [Knecht 2011, Tables 5.5 to 5.7]: a chest CT X-rayed onto a wall, at three resolutions.
#include "bench_suites.hpp"
#include "bench_variants.hpp"

namespace cdsm::cli {

std::vector<Table> benchVolumeSize(const BenchOptions& options) {
  std::vector<Scene> scenes;
  for (const char* size : {"512", "256", "128"})
    scenes.push_back(readBenchScene(options, "papers/xray/xray_" + std::string(size) + ".toml"));
  return benchVariants(options, "voxels", {"512x512x96", "256x256x48", "128x128x24"}, scenes,
                       {{"5.5", "atlas", "atlas (thesis: 3D textures)", {84, 64, 52}, {570, 252, 113}},
                        {"5.6", "chunked", "chunked", {74, 55, 52}, {846, 340, 130}}},
                       {"5.7", {3.74, 3.64, 3.64}, {31, 27, 24}});
}

}  // namespace cdsm::cli
