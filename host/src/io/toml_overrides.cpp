// SPDX-License-Identifier: Apache-2.0
#include "io/toml_overrides.hpp"

#include "io/text_numbers.hpp"
#include "io/toml_reader.hpp"

namespace cdsm::io {
namespace {

struct Setting {
  Location place;  ///< the option as it was given, for messages
  ScenePath path;
  std::string value;
};

Setting parseSetting(const std::string& text) {
  Setting setting;
  setting.place.file = std::string(kOverridePrefix) + text;
  const std::size_t equals = text.find('=');
  const auto path = splitScenePath(std::string(trimmed(std::string_view(text).substr(0, equals))));
  if (equals == std::string::npos || !path) {
    throw Error(setting.place, "must be KEY=VALUE with a dotted KEY such as image.width or light.NAME.cutoff");
  }
  setting.path = *path;
  setting.value = trimmed(std::string_view(text).substr(equals + 1));
  return setting;
}

/// A table with the value under the setting's key.
toml::table parseValue(const Setting& setting) {
  try {
    toml::table parsed = parseEntry(setting.path.key, setting.value, setting.place.file);
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error&) {
    // not TOML: a name without quotes
  }
  try {
    return parseEntry(setting.path.key, quoteToml(setting.value), setting.place.file);
  } catch (const toml::parse_error& error) {
    throw Error(setting.place, std::string(error.description()));
  }
}

}  // namespace

ScenePath applyOverride(toml::table& scene, const std::string& text) {
  const Setting setting = parseSetting(text);
  toml::table& table = tableAt(scene, setting.path, setting.place);
  putEntry(table, parseValue(setting));
  return setting.path;
}

}  // namespace cdsm::io
