// SPDX-License-Identifier: Apache-2.0
#include "io/scene_keys.hpp"

#include <map>

namespace cdsm::io {
namespace {

const std::map<std::string, std::vector<SceneKey>> kKeys{
    {"camera",
     {{"position", KeyShape::Vector},
      {"target", KeyShape::Vector},
      {"up", KeyShape::Vector},
      {"fov", KeyShape::Number}}},
    {"image",
     {{"width", KeyShape::Integer},
      {"height", KeyShape::Integer},
      {"background", KeyShape::Vector},
      {"ambient", KeyShape::Vector},
      {"supersampling", KeyShape::Integer}}},
    {"shadows",
     {{"technique", KeyShape::Text},
      {"memory", KeyShape::Text},
      {"max_nodes", KeyShape::Integer},
      {"node_format", KeyShape::Text},
      {"map_size", KeyShape::Integer},
      {"tolerance", KeyShape::Number},
      {"tolerance_mode", KeyShape::Text},
      {"filter", KeyShape::Text},
      {"rays", KeyShape::Text},
      {"step", KeyShape::Number},
      {"memory_limit_mb", KeyShape::Number},
      {"on_overflow", KeyShape::Text},
      {"bias", KeyShape::Number},
      {"transmittance", KeyShape::Text},
      {"cache", KeyShape::Text},
      {"clusters", KeyShape::Integer},
      {"cluster_distance", KeyShape::Number},
      {"stable", KeyShape::Flag},
      {"threshold", KeyShape::Number},
      {"samples", KeyShape::Integer},
      {"seed", KeyShape::Integer},
      {"stratified", KeyShape::Flag},
      {"pcf", KeyShape::Integer},
      {"patch", KeyShape::Integer},
      {"softness", KeyShape::Number},
      {"softness_distance", KeyShape::Number},
      {"softness_exponent", KeyShape::Number}}},
    {"light",
     {{"name", KeyShape::Text},
      {"type", KeyShape::Text},
      {"position", KeyShape::Vector},
      {"target", KeyShape::Vector},
      {"direction", KeyShape::Vector},
      {"cutoff", KeyShape::Number},
      {"color", KeyShape::Vector}}},
    {"material",
     {{"name", KeyShape::Text},
      {"diffuse", KeyShape::Vector},
      {"specular", KeyShape::Vector},
      {"shininess", KeyShape::Number},
      {"opacity", KeyShape::Number},
      {"transmission", KeyShape::Vector}}},
    {"mesh",
     {{"name", KeyShape::Text},
      {"file", KeyShape::Text},
      {"material", KeyShape::Text},
      {"position", KeyShape::Vector},
      {"rotation", KeyShape::Rotation},
      {"scale", KeyShape::Scale},
      {"matrix", KeyShape::Matrix},
      {"interior_extinction", KeyShape::Number},
      {"interior_color", KeyShape::Vector},
      {"casts_shadow", KeyShape::Flag},
      {"receives_shadow", KeyShape::Flag},
      {"cluster_weight", KeyShape::Number}}},
    {"volume",
     {{"name", KeyShape::Text},
      {"file", KeyShape::Text},
      {"grid", KeyShape::Text},
      {"array", KeyShape::Text},
      {"boundary", KeyShape::Text},
      {"opacity", KeyShape::Pairs},
      {"shadow_opacity", KeyShape::Pairs},
      {"color", KeyShape::Quads},
      {"transfer_function", KeyShape::Text},
      {"range", KeyShape::Interval},
      {"transmission", KeyShape::Quads},
      {"unit_distance", KeyShape::Number},
      {"specular", KeyShape::Vector},
      {"shininess", KeyShape::Number},
      {"shading", KeyShape::Flag},
      {"position", KeyShape::Vector},
      {"rotation", KeyShape::Rotation},
      {"scale", KeyShape::Scale},
      {"matrix", KeyShape::Matrix},
      {"casts_shadow", KeyShape::Flag},
      {"receives_shadow", KeyShape::Flag},
      {"cluster_weight", KeyShape::Number}}},
};

}  // namespace

const std::vector<SceneKey>& keysOf(const std::string& kind) { return kKeys.at(kind); }

std::vector<std::string> keyNamesOf(const std::string& kind) {
  std::vector<std::string> names;
  for (const SceneKey& key : keysOf(kind)) names.push_back(key.name);
  return names;
}

}  // namespace cdsm::io
