// SPDX-License-Identifier: Apache-2.0
// compare.json; its keys are those of docs/compare.md.
#include <nlohmann/json.hpp>

#include "comparison.hpp"

namespace cdsm::cli {
namespace {

using Json = nlohmann::ordered_json;

Json settingsJson(const ShadowVariant& variant) {
  Json settings;
  for (const ShadowSetting& setting : variant.settings) settings[std::string("shadows.") + setting.key] = setting.value;
  return settings;
}

Json resultJson(const VariantResult& result) {
  Json json{{"name", result.variant.name}, {"settings", settingsJson(result.variant)}};
  if (!result.reason.empty()) {
    json["reason"] = result.reason;
    return json;
  }
  json["image"] = pictureName(result.variant);
  if (result.variant.name != referenceVariant().name) json["difference"] = differenceName(result.variant);
  json["error"] = {{"rms", result.difference.rms},
                   {"mean_luminance", result.difference.mean},
                   {"largest", result.difference.largest},
                   {"perceived", result.difference.perceived}};
  json["time_ms"] = {{"build", result.buildMs}, {"frame", result.frameMs}};
  json["frames_timed"] = result.frames;
  json["maps"] = result.maps;
  json["bytes"] = result.bytes;
  json["warnings"] = result.warnings;
  return json;
}

}  // namespace

std::string comparisonJson(const Comparison& comparison) {
  Json techniques = Json::array();
  for (const VariantResult& result : comparison.results) techniques.push_back(resultJson(result));
  const Json json{{"scene", comparison.scene},
                  {"settings", comparison.settings},
                  {"device",
                   {{"platform", comparison.device.platform},
                    {"name", comparison.device.name},
                    {"version", comparison.device.version}}},
                  {"image",
                   {{"width", comparison.image.width},
                    {"height", comparison.image.height},
                    {"supersampling", comparison.image.supersampling}}},
                  {"reference", referenceVariant().name},
                  {"difference_factor", kDifferenceFactor},
                  {"techniques", techniques}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cdsm::cli
