// SPDX-License-Identifier: Apache-2.0
// [[light]], [[material]], [[mesh]] and [[volume]] of a scene file.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/object_keys.hpp"
#include "io/preset_file.hpp"
#include "io/scene_keys.hpp"
#include "io/scene_parts.hpp"
#include "io/spelling.hpp"
#include "scene/light_names.hpp"
#include "scene/range.hpp"
#include "scene/validate.hpp"

namespace cdsm::io {
namespace {

const Choices kTransmissions{"color"};
const Choices kLightTypes{"spot", "omni", "directional"};

/// Keys that not all lights have, and the types that have them.
const std::vector<std::pair<const char*, std::vector<LightType>>> kTypedLightKeys{
    {"position", {LightType::Spot, LightType::Omni}},
    {"target", {LightType::Spot}},
    {"cutoff", {LightType::Spot}},
    {"direction", {LightType::Directional}}};

std::optional<std::pair<double, double>> readRange(const TableReader& reader) {
  if (!reader.has("range")) return std::nullopt;
  if (!reader.has("transfer_function")) reader.fail("range", "range stretches a transfer_function, which is not given");
  const std::vector<float> range = reader.numbers("range", 2, scene::kAnyNumber);
  if (!(range[0] < range[1])) reader.fail("range", "range must be [low, high] with low below high");
  return std::pair<double, double>(range[0], range[1]);
}

/// The functions of a preset, whose keys must not be there as well.
TransferFunction readPresetOf(const TableReader& reader, const AssetCache& assets) {
  const auto range = readRange(reader);
  if (!reader.has("transfer_function")) return {};
  const TransferFunction preset = readPreset(assets.pathOf(requiredText(reader, "transfer_function")), range);
  if (reader.has("color")) reader.fail("color", "color and transfer_function are given, must be one of them");
  if (reader.has("opacity") && !preset.opacity.empty())
    reader.fail("opacity", "opacity is given, and the transfer_function has opacities, must be one of them");
  if (!reader.has("opacity") && preset.opacity.empty())
    reader.fail("transfer_function", "the preset has no opacities, must be joined by the key opacity");
  return preset;
}

std::vector<TransferFunction::OpacityPoint> readOpacity(const TableReader& reader, const char* key) {
  std::vector<TransferFunction::OpacityPoint> points;
  for (const auto& row : reader.points(key, 2, scene::kUnitInterval)) points.push_back({row[0], row[1]});
  return points;
}

std::vector<TransferFunction::ColorPoint> readColors(const TableReader& reader, const char* key,
                                                     const scene::Range& range) {
  std::vector<TransferFunction::ColorPoint> points;
  for (const auto& row : reader.points(key, 4, range)) points.push_back({row[0], {row[1], row[2], row[3]}});
  return points;
}

/// Points of its own, none, or "color": light takes on the colour of what it gets through, of which no more than all
/// gets through.
std::vector<TransferFunction::ColorPoint> readTransmission(const TableReader& reader,
                                                           std::vector<TransferFunction::ColorPoint> color) {
  const toml::node* node = reader.table().get("transmission");
  if (!node || (node->is_array() && node->as_array()->empty())) return {};
  if (!node->is_string()) return readColors(reader, "transmission", scene::kUnitInterval);
  reader.choice("transmission", "color", kTransmissions);
  for (TransferFunction::ColorPoint& point : color) point.color = glm::min(point.color, glm::vec3(1.0f));
  return color;
}

TransferFunction readTransferFunction(const TableReader& reader, const AssetCache& assets) {
  TransferFunction transfer = readPresetOf(reader, assets);
  if (transfer.opacity.empty()) transfer.opacity = readOpacity(reader, "opacity");
  if (reader.has("shadow_opacity")) transfer.shadowOpacity = readOpacity(reader, "shadow_opacity");
  if (transfer.color.empty()) transfer.color = readColors(reader, "color", scene::kNotNegative);
  transfer.transmission = readTransmission(reader, transfer.color);
  transfer.unitDistance = reader.number("unit_distance", transfer.unitDistance, scene::kPositive);
  return transfer;
}

LightType readLightType(const TableReader& reader) {
  const std::string name = reader.choice("type", "spot", kLightTypes);
  for (const LightType type : {LightType::Omni, LightType::Directional})
    if (name == scene::nameOf(type)) return type;
  return LightType::Spot;
}

/// A key that means nothing for the light's type is a mistake in one of the two.
void refuseKeysOfOtherTypes(const TableReader& reader, LightType type) {
  std::vector<std::string> right;
  for (const auto& [key, types] : kTypedLightKeys)
    if (std::find(types.begin(), types.end(), type) != types.end()) right.push_back(key);
  for (const auto& [key, types] : kTypedLightKeys) {
    if (!reader.has(key) || std::find(types.begin(), types.end(), type) != types.end()) continue;
    std::vector<std::string> owners;
    for (const LightType owner : types) owners.push_back(scene::nameOf(owner));
    reader.fail(key, std::string("'") + key + "' is of lights of type " + joinNames(owners) +
                         ", must be left out of type " + scene::nameOf(type) + ", which has: " + joinNames(right));
  }
}

}  // namespace

Light readLight(const toml::table& table) {
  const TableReader reader(table, "[[light]]", keyNamesOf("light"));
  Light light;
  light.name = requiredText(reader, "name");
  light.type = readLightType(reader);
  refuseKeysOfOtherTypes(reader, light.type);
  light.position = reader.vector("position", light.position, scene::kCoordinate);
  light.target = reader.vector("target", light.target, scene::kCoordinate);
  light.direction = reader.vector("direction", light.direction, scene::kCoordinate);
  light.cutoff = reader.number("cutoff", light.cutoff, scene::kCutoff);
  light.color = reader.vector("color", light.color, scene::kNotNegative);
  reader.locate("", [&] { scene::validateLight(light); });
  return light;
}

Material readMaterial(const toml::table& table) {
  const TableReader reader(table, "[[material]]", keyNamesOf("material"));
  Material material;
  material.name = requiredText(reader, "name");
  material.diffuse = reader.vector("diffuse", material.diffuse, scene::kNotNegative);
  material.specular = reader.vector("specular", material.specular, scene::kNotNegative);
  material.shininess = reader.number("shininess", material.shininess, scene::kNotNegative);
  material.opacity = reader.number("opacity", material.opacity, scene::kUnitInterval);
  material.transmission = reader.vector("transmission", material.transmission, scene::kUnitInterval);
  return material;
}

Mesh readMeshTable(const toml::table& table, const Scene& scene, AssetCache& assets) {
  const TableReader reader(table, "[[mesh]]", keyNamesOf("mesh"));
  Mesh mesh;
  mesh.name = requiredText(reader, "name");
  const std::string file = requiredText(reader, "file");
  reader.require("material");
  mesh.material = indexOf(reader, "material", scene.materials, "material");
  mesh.worldFromObject = readTransform(reader);
  mesh.interiorExtinction = reader.number("interior_extinction", mesh.interiorExtinction, scene::kNotNegative);
  mesh.interiorColor = reader.vector("interior_color", mesh.interiorColor, scene::kNotNegative);
  mesh.interiorTransmission = reader.vector("interior_transmission", mesh.interiorTransmission, scene::kUnitInterval);
  mesh.shadow = readShadowRole(reader);
  reader.locate("file", [&] { mesh.data = assets.mesh(file); });
  reader.locate("file", [&] { scene::validateMesh(mesh, scene.materials.size(), assets.checks()); });
  return mesh;
}

Volume readVolumeTable(const toml::table& table, const Scene& scene, AssetCache& assets) {
  const TableReader reader(table, "[[volume]]", keyNamesOf("volume"));
  Volume volume;
  volume.name = requiredText(reader, "name");
  const std::string file = requiredText(reader, "file");
  volume.transfer = readTransferFunction(reader, assets);
  volume.worldFromObject = readTransform(reader);
  volume.specular = reader.vector("specular", volume.specular, scene::kNotNegative);
  volume.shininess = reader.number("shininess", volume.shininess, scene::kNotNegative);
  volume.shading = reader.flag("shading", volume.shading);
  volume.shadow = readShadowRole(reader);
  if (!reader.text("boundary", "").empty()) volume.boundary = indexOf(reader, "boundary", scene.meshes, "mesh");
  const VolumePart part{reader.text("grid", ""), reader.text("array", "")};
  reader.locate(!part.grid.empty()    ? "grid"
                : !part.array.empty() ? "array"
                                      : "file",
                [&] { volume.data = assets.volume(file, part); });
  reader.locate(volume.boundary < 0 ? "file" : "boundary",
                [&] { scene::validateVolume(volume, scene.meshes, assets.checks()); });
  return volume;
}

}  // namespace cdsm::io
