// SPDX-License-Identifier: Apache-2.0
// Scene files: TOML in, a valid Scene with its meshes and volumes out. docs/scene-file.md is the reference of the keys.
#pragma once

#include <string>
#include <vector>

#include <cdsm/scene.hpp>

namespace cdsm::io {

/// Reads a scene file and all files that it names, relative to its own folder; a file used twice is read once and
/// shared. `overrides` are KEY=VALUE with dotted keys (see toml_overrides.hpp), applied in their order before reading.
/// The scene returned passes validate(). Throws Error with file, line and column of the key or value at fault, or with
/// the override's text; an Error of a mesh's or volume's reader keeps the place that the reader gave it.
Scene readScene(const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace cdsm::io
