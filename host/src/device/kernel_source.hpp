// SPDX-License-Identifier: Apache-2.0
// Joins kernel files into one text. In: an entry file, defines and generated files; out: OpenCL C without includes
// whose #line marks let the compiler name the real files and lines.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cdsm::device {

struct ProgramSource {
  std::string entry;  ///< path relative to kernels/, e.g. "build/build_map.cl"; may be a generated file or absolute
  /// NAME, value. A value in quotes is a path for `#include NAME`; others become `#define NAME value`, an empty one 1.
  std::vector<std::pair<std::string, std::string>> defines;
  std::map<std::string, std::string> generated;  ///< path, text: files that exist in no folder; they win over others
};

/// The text with each `#include "path"` (relative to kernels/) and `#include NAME` replaced by that file, each file
/// once, and `#pragma once` dropped. `#include <...>` stays. Only lines that start with the directive are seen, and
/// they are seen inside #if, too. An absolute path is read from disk; other files come from `generated`, then from the
/// folder CDSM_KERNELS if that is set, else from the library. Throws Error with file and line for what cannot be found.
std::string joinSource(const ProgramSource& source);

}  // namespace cdsm::device
