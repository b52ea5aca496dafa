// SPDX-License-Identifier: Apache-2.0
// The scenes of [Knecht 2011, Figure 5.14], all with four clusters of 256^2 for each light.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench_subject.hpp"

namespace cdsm::cli {

struct PaperScene {
  const char* name;
  const char* file;  ///< in the folder of scenes
};

const std::vector<PaperScene>& paperScenes();

/// Their names.
std::vector<std::string> paperColumns();

/// Shows each scene to `visit`, one after the other: their engines do not live at the same time.
void forEachPaperScene(const BenchOptions& options, const std::function<void(Subject&)>& visit);

}  // namespace cdsm::cli
