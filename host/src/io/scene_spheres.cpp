// SPDX-License-Identifier: Apache-2.0
// [[spheres]] of a scene file.
#include <cmath>
#include <string>

#include "io/object_keys.hpp"
#include "io/scene_keys.hpp"
#include "io/scene_parts.hpp"
#include "scene/range.hpp"

namespace cdsm::io {
namespace {

const Choices kColors{{"element"}, {}};
/// Of cosines and relative lengths: matrices are written with few digits.
constexpr float kNotSimilar = 1e-3f;

std::optional<glm::vec3> readColor(const TableReader& reader) {
  if (reader.has("color") && !reader.table().get("color")->is_string())
    return reader.vector("color", glm::vec3(1.0f), scene::kNotNegative);
  reader.choice("color", "element", kColors);
  return std::nullopt;
}

/// Spheres stay spheres: axes of one length, at right angles.
bool isSimilarity(const glm::mat4& matrix) {
  const glm::mat3 axes(matrix);
  const float length = glm::length(axes[0]);
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(glm::length(axes[i]) - length) <= kNotSimilar * length)) return false;
    if (!(std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) <= kNotSimilar * length * length)) return false;
  }
  return length > 0.0f;
}

glm::mat4 readSimilarity(const TableReader& reader) {
  reader.number("scale", 1.0f, scene::kCoordinate);  // three would be refused only if they differ
  const glm::mat4 matrix = readTransform(reader);
  if (!isSimilarity(matrix))
    reader.fail("matrix", "the transform of spheres must scale all axes alike and leave them at right angles");
  return matrix;
}

}  // namespace

Spheres readSpheresTable(const toml::table& table, const Scene& scene, AssetCache& assets) {
  const TableReader reader(table, "[[spheres]]", keyNamesOf("spheres"));
  Spheres spheres;
  spheres.name = requiredText(reader, "name");
  const std::string file = requiredText(reader, "file");
  SphereLook look;
  look.radius = reader.number("radius", look.radius, scene::kNotNegative);
  look.color = readColor(reader);
  look.waters = reader.flag("waters", look.waters);
  reader.require("material");
  spheres.material = indexOf(reader, "material", scene.materials, "material");
  spheres.worldFromObject = readSimilarity(reader);
  spheres.shadow = readShadowRole(reader);
  reader.locate("file", [&] { spheres.data = assets.spheres(file, look); });
  return spheres;
}

}  // namespace cdsm::io
