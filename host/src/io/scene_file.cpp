// SPDX-License-Identifier: Apache-2.0
// A scene file from text to Scene: parse, override, read table by table.
#include "io/scene_file.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "io/input_file.hpp"
#include "io/scene_keys.hpp"
#include "io/scene_parts.hpp"
#include "io/toml_overrides.hpp"
#include "io/toml_reader.hpp"

namespace cdsm::io {
namespace {

namespace fs = std::filesystem;

toml::table parseScene(const std::string& path) {
  if (!fs::exists(path)) throw Error(Location{path}, "there is no such file, must be a scene file");
  try {
    return toml::parse(readText(path), path);
  } catch (const toml::parse_error& error) {
    failAt(error.source(), std::string(error.description()) + "; must be TOML");
  }
}

std::vector<std::string> allTables() {
  std::vector<std::string> names;
  for (const auto* list : {&kSceneTables, &kSceneArrays, &kLaterSceneTables}) {
    names.insert(names.end(), list->begin(), list->end());
  }
  return names;
}

/// The table of that name, or nothing.
const toml::table* findTable(const TableReader& root, const std::string& name) {
  if (!root.has(name)) return nullptr;
  const toml::table* table = root.table().get(name)->as_table();
  if (!table) root.fail(name, "'" + name + "' is a value, must be a table [" + name + "]");
  return table;
}

std::vector<const toml::table*> findTables(const TableReader& root, const std::string& name) {
  std::vector<const toml::table*> tables;
  if (!root.has(name)) return tables;
  const std::string message = "'" + name + "' is something else, must be tables [[" + name + "]]";
  const toml::array* array = root.table().get(name)->as_array();
  if (!array) root.fail(name, message);
  for (const toml::node& element : *array) {
    if (!element.is_table()) failAt(element.source(), message);
    tables.push_back(element.as_table());
  }
  return tables;
}

/// A name may also come from the command line.
std::string lineText(const Location& place) {
  return place.line > 0 ? "line " + std::to_string(place.line) : place.file;
}

/// Reads every [[kind]] table into `objects`, whose names must differ.
template <typename Object, typename Read>
void readAll(const TableReader& root, const std::string& kind, std::vector<Object>& objects, Read read) {
  std::map<std::string, Location> places;  // of the names so far
  for (const toml::table* table : findTables(root, kind)) {
    Object object = read(*table);
    const toml::source_region& source = table->get("name")->source();
    const auto [first, isNew] = places.emplace(object.name, locationOf(source));
    if (!isNew) {
      failAt(source, kind + " '" + object.name + "' is already in " + lineText(first->second) + ", names must differ");
    }
    objects.push_back(std::move(object));
  }
}

Scene readTree(const toml::table& tree, const std::string& folder) {
  const TableReader root(tree, "the scene", allTables());
  for (const std::string& name : kLaterSceneTables) root.refuse(name);
  Scene scene;
  AssetCache assets(folder);
  if (const toml::table* table = findTable(root, "camera")) scene.camera = readCamera(*table);
  if (const toml::table* table = findTable(root, "image")) scene.image = readImageSettings(*table);
  if (const toml::table* table = findTable(root, "shadows")) scene.shadows = readShadows(*table);
  readAll(root, "light", scene.lights, readLight);
  readAll(root, "material", scene.materials, readMaterial);
  readAll(root, "mesh", scene.meshes, [&](const toml::table& table) { return readMeshTable(table, scene, assets); });
  readAll(root, "volume", scene.volumes,
          [&](const toml::table& table) { return readVolumeTable(table, scene, assets); });
  return scene;
}

}  // namespace

Scene readScene(const std::string& path, const std::vector<std::string>& overrides) {
  toml::table tree = parseScene(path);
  for (const std::string& setting : overrides) applyOverride(tree, setting);
  return readTree(tree, fs::path(path).parent_path().string());
}

}  // namespace cdsm::io
