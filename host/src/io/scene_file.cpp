// SPDX-License-Identifier: Apache-2.0
// A scene file from text to Scene: parse, override, animate, read table by table.
#include "io/scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "io/animation.hpp"
#include "io/input_file.hpp"
#include "io/scene_keys.hpp"
#include "io/scene_parts.hpp"
#include "io/toml_overrides.hpp"
#include "io/toml_reader.hpp"

#include "scene/validate.hpp"

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
  for (const auto* list : {&kSceneTables, &kSceneArrays}) {
    names.insert(names.end(), list->begin(), list->end());
  }
  names.push_back(kAnimateArray);
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

/// Checks of what only the whole scene can tell, with the place of a key of the table, or of the table itself.
void requireOf(const TableReader& root, const std::string& table, const std::string& key,
               const std::function<void()>& check) {
  if (const toml::table* found = findTable(root, table))
    TableReader(*found, "[" + table + "]", keyNamesOf(table)).locate(key, check);
}

Scene readTree(const toml::table& tree, AssetCache& assets) {
  const TableReader root(tree, "the scene", allTables());
  Scene scene;
  if (const toml::table* table = findTable(root, "camera")) scene.camera = readCamera(*table);
  if (const toml::table* table = findTable(root, "image")) scene.image = readImageSettings(*table);
  if (const toml::table* table = findTable(root, "shadows")) scene.shadows = readShadows(*table);
  if (const toml::table* table = findTable(root, "ambient_occlusion")) scene.ambientOcclusion = readOcclusion(*table);
  readAll(root, "light", scene.lights, readLight);
  readAll(root, "material", scene.materials, readMaterial);
  readAll(root, "mesh", scene.meshes, [&](const toml::table& table) { return readMeshTable(table, scene, assets); });
  readAll(root, "volume", scene.volumes,
          [&](const toml::table& table) { return readVolumeTable(table, scene, assets); });
  readAll(root, "spheres", scene.spheres,
          [&](const toml::table& table) { return readSpheresTable(table, scene, assets); });
  requireOf(root, "shadows", "technique", [&] { scene::validateTechnique(scene); });
  requireOf(root, "ambient_occlusion", "", [&] { scene::validateOcclusion(scene); });
  return scene;
}

/// All [[animate]] tables, each about another key, and none about one of `overridden`.
std::vector<Animation> readAnimations(toml::table& tree, const std::vector<ScenePath>& overridden,
                                      const std::vector<std::string>& overrides) {
  std::vector<Animation> animations;
  for (const toml::table* table : findTables(TableReader(tree, "the scene", allTables()), kAnimateArray)) {
    Animation animation(*table, tree);
    for (const Animation& other : animations) {
      if (!(other.path() == animation.path())) continue;
      throw Error(animation.place(), "'" + animation.pathText() + "' is already animated in " +
                                         lineText(other.place()) + ", must be animated once");
    }
    const auto match = std::find(overridden.begin(), overridden.end(), animation.path());
    if (match != overridden.end()) {
      throw Error(
          Location{std::string(kOverridePrefix) + overrides[match - overridden.begin()]},
          "the key is animated in " + lineText(animation.place()) + " of the scene file, must be changed there");
    }
    animations.push_back(std::move(animation));
  }
  return animations;
}

}  // namespace

struct SceneReader::Parts {
  toml::table tree;  ///< animated values are those of the frame that was read last
  std::vector<Animation> animations;
  AssetCache assets;
};

SceneReader::SceneReader(const std::string& path, const std::vector<std::string>& overrides)
    : parts_(new Parts{parseScene(path), {}, AssetCache(fs::path(path).parent_path().string())}) {
  std::vector<ScenePath> overridden;
  for (const std::string& setting : overrides) overridden.push_back(applyOverride(parts_->tree, setting));
  parts_->animations = readAnimations(parts_->tree, overridden, overrides);
}

SceneReader::~SceneReader() = default;
SceneReader::SceneReader(SceneReader&&) noexcept = default;
SceneReader& SceneReader::operator=(SceneReader&&) noexcept = default;

bool SceneReader::animated() const { return !parts_->animations.empty(); }

Scene SceneReader::frame(int number) {
  for (const Animation& animation : parts_->animations) animation.apply(parts_->tree, number);
  try {
    return readTree(parts_->tree, parts_->assets);
  } catch (const Error& error) {
    for (const Animation& animation : parts_->animations) {
      if (!error.where() || error.where()->file != animation.source()) continue;
      throw Error(animation.place(), "frame " + std::to_string(number) + ": " + error.message());
    }
    throw;
  }
}

Scene readScene(const std::string& path, const std::vector<std::string>& overrides) {
  return SceneReader(path, overrides).frame(0);
}

}  // namespace cdsm::io
