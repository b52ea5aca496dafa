// SPDX-License-Identifier: Apache-2.0
// Dotted paths into the TOML tree of a scene: TABLE.KEY (image.width) or, in arrays of tables, KIND.NAME.KEY
// (light.key.cutoff is the cutoff of the [[light]] whose name is "key").
#pragma once

#include <optional>
#include <string>

#include <toml++/toml.h>

#include <cdsm/error.hpp>

namespace cdsm::io {

struct ScenePath {
  std::string kind;  ///< of a table or an array of tables
  std::string name;  ///< of the array's element, empty for a table; may itself hold dots
  std::string key;

  bool operator==(const ScenePath& other) const { return kind == other.kind && name == other.name && key == other.key; }
};

/// Nothing when the text has no dot. Says nothing about whether the scene has such a thing.
std::optional<ScenePath> splitScenePath(const std::string& text);

/// The table that the path's key belongs to; a table without a name is added when the scene lacks it. Throws Error at
/// `place` for unknown kinds and names.
toml::table& tableAt(toml::table& scene, const ScenePath& path, const Location& place);

/// A table of one key, parsed from TOML: only the parser gives nodes a source, and with it a place for errors. `source`
/// is what it calls their file. Throws toml::parse_error.
toml::table parseEntry(const std::string& key, const std::string& value, const std::string& source);

/// Puts what parseEntry() made in the place of an earlier value.
void putEntry(toml::table& table, toml::table entry);

/// Text as a TOML string in quotes.
std::string quoteToml(const std::string& text);

}  // namespace cdsm::io
