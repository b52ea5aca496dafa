// SPDX-License-Identifier: Apache-2.0
// Dotted paths into the TOML tree of a scene.
#include "io/toml_overrides.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "io/scene_keys.hpp"
#include "io/spelling.hpp"
#include "io/toml_reader.hpp"

namespace cdsm::io {
namespace {

struct Setting {
  Location place;    ///< the option as it was given, for messages
  std::string kind;  ///< of a table or an array of tables
  std::string name;  ///< of the array's element, empty for a table
  std::string key;
  std::string value;
};

std::string trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return std::string(text);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A name may itself hold dots: it reaches from the first dot to the last.
Setting parseSetting(const std::string& text) {
  Setting setting;
  setting.place.file = std::string(kOverridePrefix) + text;
  const std::size_t equals = text.find('=');
  const std::string path = trimmed(text.substr(0, equals));
  const std::size_t first = path.find('.'), last = path.rfind('.');
  if (equals == std::string::npos || first == std::string::npos) {
    throw Error(setting.place, "must be KEY=VALUE with a dotted KEY such as image.width or light.NAME.cutoff");
  }
  setting.kind = path.substr(0, first);
  if (last > first) setting.name = path.substr(first + 1, last - first - 1);
  setting.key = path.substr(last + 1);
  setting.value = trimmed(text.substr(equals + 1));
  return setting;
}

/// As many names in the path as the kind of table needs.
void checkShape(const Setting& setting) {
  const bool isArray = contains(kSceneArrays, setting.kind);
  if (contains(kLaterSceneTables, setting.kind)) {
    throw Error(setting.place, "'" + setting.kind + "' is not supported yet");
  }
  if (!isArray && !contains(kSceneTables, setting.kind)) {
    std::vector<std::string> known = kSceneTables;
    known.insert(known.end(), kSceneArrays.begin(), kSceneArrays.end());
    throw Error(setting.place, "unknown table '" + setting.kind + "'" + suggestion(setting.kind, known));
  }
  if (isArray == setting.name.empty()) {
    const std::string right = setting.kind + (isArray ? ".NAME.KEY" : ".KEY");
    throw Error(setting.place, "the key must have the form " + right);
  }
}

/// Text as a TOML string in quotes.
std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/// A table with the value under the setting's key. The text goes through the parser even when it is a plain string,
/// because only the parser gives nodes a source, and with it a place for errors.
toml::table parseValue(const Setting& setting) {
  const std::string left = quote(setting.key) + " = ";
  try {
    toml::table parsed = toml::parse(left + setting.value, setting.place.file);
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error&) {
    // not TOML: a name without quotes
  }
  try {
    return toml::parse(left + quote(setting.value), setting.place.file);
  } catch (const toml::parse_error& error) {
    throw Error(setting.place, std::string(error.description()));
  }
}

toml::table& findTable(toml::table& scene, const Setting& setting) {
  if (!scene.contains(setting.kind)) scene.insert(setting.kind, toml::table{});
  toml::table* table = scene.get(setting.kind)->as_table();
  if (!table) throw Error(setting.place, "'" + setting.kind + "' is not a table in the scene file, must be one");
  return *table;
}

toml::table& findElement(toml::table& scene, const Setting& setting) {
  std::vector<std::string> names;
  toml::node* node = scene.get(setting.kind);
  if (toml::array* elements = node ? node->as_array() : nullptr) {
    for (toml::node& element : *elements) {
      toml::table* table = element.as_table();
      const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
      if (name == setting.name) return *table;
      if (name) names.push_back(*name);
    }
  }
  throw Error(setting.place, "unknown " + setting.kind + " '" + setting.name + "', " +
                                 (names.empty() ? "the scene has none" : "must be one of: " + joinNames(names)));
}

}  // namespace

void applyOverride(toml::table& scene, const std::string& text) {
  const Setting setting = parseSetting(text);
  checkShape(setting);
  toml::table parsed = parseValue(setting);
  toml::table& table = setting.name.empty() ? findTable(scene, setting) : findElement(scene, setting);
  const toml::key& key = parsed.begin()->first;
  table.erase(key.str());  // also drops the old key, whose place is in the file
  parsed.begin()->second.visit([&](auto& value) { table.insert(key, std::move(value)); });
}

}  // namespace cdsm::io
