// SPDX-License-Identifier: Apache-2.0
// Suite "tolerance" [Knecht 2011, Tables 5.8 to 5.10]: the X-rayed chest at four tolerances.
#include "bench_suites.hpp"
#include "bench_variants.hpp"

namespace cdsm::cli {

std::vector<Table> benchTolerance(const BenchOptions& options) {
  const Scene scene = readBenchScene(options, "papers/xray/overview.toml");
  std::vector<Scene> variants;
  std::vector<std::string> columns;
  for (const float tolerance : {0.01f, 0.05f, 0.1f, 0.2f}) {
    variants.push_back(scene);
    variants.back().shadows.tolerance = tolerance;
    columns.push_back(numberText(tolerance));
  }
  return benchVariants(options, "tolerance", columns, variants,
                       {{"5.8", "atlas", "atlas (thesis: 3D textures)", {70, 69, 66, 65}, {166, 159, 153, 149}},
                        {"5.9", "chunked", "chunked", {68, 62, 65, 63}, {287, 253, 231, 213}}},
                       {"5.10", {4.01, 3.32, 3.12, 3.00}, {28, 21, 21, 21}});
}

}  // namespace cdsm::cli
