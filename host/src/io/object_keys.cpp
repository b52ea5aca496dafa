// SPDX-License-Identifier: Apache-2.0
// Names, transforms and shadow roles; see object_keys.hpp.
#include "io/object_keys.hpp"

#include "scene/range.hpp"
#include "scene/transform.hpp"

namespace cdsm::io {
namespace {

glm::mat4 readMatrix(const TableReader& reader) {
  for (const char* part : {"position", "rotation", "scale"}) {
    if (reader.has(part)) reader.fail("matrix", std::string("matrix and ") + part + " are given, must be one of them");
  }
  const std::vector<float> rows = reader.numbers("matrix", 16, scene::kCoordinate);
  glm::mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = rows[4 * row + column];
  }
  return matrix;
}

glm::vec3 readScale(const TableReader& reader) {
  if (reader.has("scale") && reader.table().get("scale")->is_array()) {
    return reader.vector("scale", glm::vec3(1.0f), scene::kCoordinate);
  }
  return glm::vec3(reader.number("scale", 1.0f, scene::kCoordinate));
}

}  // namespace

std::string requiredText(const TableReader& reader, const char* key) {
  reader.require(key);
  const std::string text = reader.text(key, "");
  if (text.empty()) reader.fail(key, std::string(key) + " is empty, must not be");
  return text;
}

glm::mat4 readTransform(const TableReader& reader) {
  if (reader.has("matrix")) return readMatrix(reader);
  const glm::vec3 position = reader.vector("position", glm::vec3(0.0f), scene::kCoordinate);
  const glm::vec3 scale = readScale(reader);
  if (scale.x == 0.0f || scale.y == 0.0f || scale.z == 0.0f) reader.fail("scale", "scale is 0, must not be");
  if (!reader.has("rotation")) return scene::composeTransform(position, glm::vec3(0.0f), 0.0f, scale);
  const std::vector<float> rotation = reader.numbers("rotation", 4, scene::kCoordinate);
  const glm::vec3 axis(rotation[0], rotation[1], rotation[2]);
  if (axis == glm::vec3(0.0f) && rotation[3] != 0.0f) {
    reader.fail("rotation", "rotation has an axis without length, must be [axis x, y, z, angle] with a direction");
  }
  return scene::composeTransform(position, axis, rotation[3], scale);
}

ShadowRole readShadowRole(const TableReader& reader) {
  ShadowRole role;
  role.casts = reader.flag("casts_shadow", role.casts);
  role.receives = reader.flag("receives_shadow", role.receives);
  role.weight = reader.number("cluster_weight", role.weight, scene::kClusterWeight);
  return role;
}

}  // namespace cdsm::io
