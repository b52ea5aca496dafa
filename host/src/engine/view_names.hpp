// SPDX-License-Identifier: Apache-2.0
// Names of the debug pictures, on the command line, in messages and statistics.
#pragma once

#include <string>
#include <vector>

#include <cdsm/cdsm.hpp>

namespace cdsm::engine {

/// In the order of DebugView.
inline const std::vector<std::string>& viewNames() {
  static const std::vector<std::string> names{"clusters", "nodes", "layers", "steps", "texels"};
  return names;
}

inline const std::string& nameOf(DebugView view) { return viewNames()[std::size_t(view)]; }

}  // namespace cdsm::engine
