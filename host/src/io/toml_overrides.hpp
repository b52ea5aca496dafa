// SPDX-License-Identifier: Apache-2.0
// `--set KEY=VALUE`: changes a parsed scene file before it is read.
#pragma once

#include <string>

#include <toml++/toml.h>

#include "io/scene_path.hpp"

namespace cdsm::io {

/// Puts a value into the tree and says where. KEY is a dotted path; VALUE is TOML, and what TOML cannot read is taken
/// as a string, so that names need no quotes. Every error about it, now or when the tree is read, says
/// `--set KEY=VALUE: ...`.
ScenePath applyOverride(toml::table& scene, const std::string& setting);

}  // namespace cdsm::io
