// SPDX-License-Identifier: Apache-2.0
// Tables of a scene in some variants (columns), for both kinds of memory: what the suites on volumes and on the
// tolerance have in common.
#pragma once

#include <string>
#include <vector>

#include "bench_subject.hpp"

namespace cdsm::cli {

/// Milliseconds of the thesis for one kind of memory, a value per variant.
struct ThesisTimes {
  std::string name;    ///< "5.5"
  std::string memory;  ///< as the scene file calls it
  std::string title;
  std::vector<double> build, frame;
};

/// Nodes per texel of the thesis, a value per variant.
struct ThesisNodes {
  std::string name;  ///< "5.7"
  std::vector<double> mean, most;
};

/// A table of times for each of `times`, and one of what the maps hold in chunked memory; four clusters of 256^2 for
/// each light.
std::vector<Table> benchVariants(const BenchOptions& options, const std::string& parameter,
                                 const std::vector<std::string>& columns, const std::vector<Scene>& variants,
                                 const std::vector<ThesisTimes>& times, const ThesisNodes& nodes);

}  // namespace cdsm::cli
