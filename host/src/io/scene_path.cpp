// SPDX-License-Identifier: Apache-2.0
#include "io/scene_path.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/scene_keys.hpp"
#include "io/spelling.hpp"

namespace cdsm::io {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// As many names in the path as the kind of table needs.
void checkShape(const ScenePath& path, const Location& place) {
  const bool isArray = contains(kSceneArrays, path.kind);
  if (path.kind == kAnimateArray) {
    throw Error(place, "'animate' has no dotted keys, its tables must be changed in the scene file");
  }
  if (!isArray && !contains(kSceneTables, path.kind)) {
    std::vector<std::string> known = kSceneTables;
    known.insert(known.end(), kSceneArrays.begin(), kSceneArrays.end());
    throw Error(place, "unknown table '" + path.kind + "'" + suggestion(path.kind, known));
  }
  if (isArray == path.name.empty()) {
    throw Error(place, "the key must have the form " + path.kind + (isArray ? ".NAME.KEY" : ".KEY"));
  }
}

toml::table& findTable(toml::table& scene, const ScenePath& path, const Location& place) {
  if (!scene.contains(path.kind)) scene.insert(path.kind, toml::table{});
  toml::table* table = scene.get(path.kind)->as_table();
  if (!table) throw Error(place, "'" + path.kind + "' is not a table in the scene file, must be one");
  return *table;
}

toml::table& findElement(toml::table& scene, const ScenePath& path, const Location& place) {
  std::vector<std::string> names;
  toml::node* node = scene.get(path.kind);
  if (toml::array* elements = node ? node->as_array() : nullptr) {
    for (toml::node& element : *elements) {
      toml::table* table = element.as_table();
      const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
      if (name == path.name) return *table;
      if (name) names.push_back(*name);
    }
  }
  throw Error(place, "unknown " + path.kind + " '" + path.name + "', " +
                         (names.empty() ? "the scene has none" : "must be one of: " + joinNames(names)));
}

}  // namespace

std::optional<ScenePath> splitScenePath(const std::string& text) {
  const std::size_t first = text.find('.'), last = text.rfind('.');
  if (first == std::string::npos) return std::nullopt;
  const std::string name = last > first ? text.substr(first + 1, last - first - 1) : "";
  return ScenePath{text.substr(0, first), name, text.substr(last + 1)};
}

toml::table& tableAt(toml::table& scene, const ScenePath& path, const Location& place) {
  checkShape(path, place);
  return path.name.empty() ? findTable(scene, path, place) : findElement(scene, path, place);
}

toml::table parseEntry(const std::string& key, const std::string& value, const std::string& source) {
  return toml::parse(quoteToml(key) + " = " + value, source);
}

void putEntry(toml::table& table, toml::table entry) {
  const toml::key& key = entry.begin()->first;
  table.erase(key.str());  // also drops the old key, whose place is in the file
  entry.begin()->second.visit([&](auto& value) { table.insert(key, std::move(value)); });
}

std::string quoteToml(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace cdsm::io
