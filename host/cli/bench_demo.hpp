// SPDX-License-Identifier: Apache-2.0
// Suite "demo": what shadows cost in a frame, what a map costs, what shadow rays would cost.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

namespace cdsm::cli {

struct DemoBenchOptions {
  std::string device;
  std::string scenes = "scenes";
  int runs = 5;
};

/// Measures in one process, prints a table to `out` and returns the figures.
nlohmann::ordered_json benchDemo(const DemoBenchOptions& options, std::ostream& out);

}  // namespace cdsm::cli
