// SPDX-License-Identifier: Apache-2.0
// `--set KEY=VALUE`: changes a parsed scene file before it is read.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace cdsm::io {

/// Puts a value into the tree. KEY is TABLE.KEY (image.width) or, for arrays of tables, KIND.NAME.KEY (light.key.cutoff
/// is the cutoff of the [[light]] whose name is "key"). VALUE is TOML; what TOML cannot read is taken as a string, so
/// that names need no quotes. Every error about it, now or when the tree is read, says `--set KEY=VALUE: ...`.
void applyOverride(toml::table& scene, const std::string& setting);

}  // namespace cdsm::io
