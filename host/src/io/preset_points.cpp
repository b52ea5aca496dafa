// SPDX-License-Identifier: Apache-2.0
// JSON and XML of presets; see preset_points.hpp.
#include "io/preset_points.hpp"

#include <algorithm>
#include <cstring>

#include <nlohmann/json.hpp>

#include <cdsm/error.hpp>

#include "io/input_file.hpp"
#include "io/text_numbers.hpp"
#include "io/xml_text.hpp"

namespace cdsm::io {

namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(const std::string& path, const std::string& message) { throw Error(Location{path}, message); }

Json parseJson(const std::string& path) {
  const std::string text = readText(path);
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n') + 1;
    throw Error(Location{path, static_cast<int>(line), 1}, "is not JSON that can be read; must be a ParaView preset");
  } catch (const Json::exception& error) {
    fail(path, "is not JSON that can be read: " + printable(error.what()));
  }
}

/// An array of presets with one element, or that element.
Json onlyPreset(const std::string& path) {
  Json json = parseJson(path);
  if (json.is_array() && json.size() == 1) json = Json(json[0]);
  if (json.is_array())
    fail(path, "holds " + std::to_string(json.size()) + " presets, must be one; export the one that is wanted");
  if (!json.is_object()) fail(path, "is no ParaView preset, must be an object with RGBPoints");
  return json;
}

/// Numbers of the key in rows of `width`; none when the key is not there.
std::vector<double> numbersOf(const std::string& path, const Json& preset, const char* key, std::size_t width) {
  std::vector<double> numbers;
  if (!preset.contains(key) || preset[key].is_null()) return numbers;
  const Json& list = preset[key];
  const bool good = list.is_array() && list.size() % width == 0 &&
                    std::all_of(list.begin(), list.end(), [](const Json& number) { return number.is_number(); });
  if (!good) fail(path, std::string(key) + " must be a list of numbers, " + std::to_string(width) + " to a point");
  for (const Json& number : list) numbers.push_back(number.get<double>());
  return numbers;
}

/// A flag of ParaView: a number or a boolean; false when the key is not there.
bool flagOf(const Json& preset, const char* key) {
  const Json value = preset.value(key, Json());
  return value.is_boolean() ? value.get<bool>() : value.is_number() && value.get<double>() != 0.0;
}

}  // namespace

PresetPoints readPresetJson(const std::string& path) {
  const Json preset = onlyPreset(path);
  if (flagOf(preset, "UseLogScale")) fail(path, "has a logarithmic scale (UseLogScale), must be linear");
  if (!preset.contains("RGBPoints"))
    fail(path, preset.contains("IndexedColors") ? "has colours of categories (IndexedColors), must have RGBPoints"
                                                : "has no RGBPoints, must be a ParaView preset");
  PresetPoints points;
  const std::vector<double> colors = numbersOf(path, preset, "RGBPoints", 4);
  for (std::size_t i = 0; i < colors.size(); i += 4)
    points.color.push_back({colors[i], {colors[i + 1], colors[i + 2], colors[i + 3]}});
  const std::vector<double> opacities = numbersOf(path, preset, "Points", 4);
  for (std::size_t i = 0; i < opacities.size(); i += 4)
    points.opacity.push_back({opacities[i], opacities[i + 1], opacities[i + 2], opacities[i + 3]});
  const Json space = preset.value("ColorSpace", Json("RGB"));
  points.space = space.is_string() ? space.get<std::string>() : space.dump(-1, ' ', true);
  if (points.space == "HSV" && flagOf(preset, "HSVWrap")) points.space = "Wrapped";
  return points;
}

PresetPoints readPresetXml(const std::string& path) {
  const std::string text = readText(path);
  const XmlText xml(path, text);
  const bool single = std::strcmp(xml.root().name(), "ColorMap") == 0;
  const pugi::xml_node map = single ? xml.root() : xml.root().child("ColorMap");
  if (!map) xml.fail(xml.root(), "has no ColorMap, must be a ParaView preset");
  if (map.next_sibling("ColorMap"))
    xml.fail(map.next_sibling("ColorMap"), "is a second ColorMap, must be one; export the one that is wanted");
  if (map.attribute("indexedLookup").as_bool()) xml.fail(map, "has colours of categories (indexedLookup)");
  PresetPoints points;
  points.space = map.attribute("space").as_string("RGB");
  for (const pugi::xml_node point : map.children("Point")) {
    const double value = xml.number(point, "x");
    points.color.push_back({value, {xml.number(point, "r"), xml.number(point, "g"), xml.number(point, "b")}});
    if (point.attribute("o")) points.opacity.push_back({value, xml.number(point, "o"), 0.5, 0.0});
  }
  // a map of colours alone says o = 1 everywhere
  if (std::all_of(points.opacity.begin(), points.opacity.end(), [](const auto& point) { return point.opacity == 1.0; }))
    points.opacity.clear();
  return points;
}

}  // namespace cdsm::io
