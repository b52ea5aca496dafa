// SPDX-License-Identifier: Apache-2.0
// Keys that several kinds of objects of a scene file have.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <cdsm/scene.hpp>

#include "io/spelling.hpp"
#include "io/toml_reader.hpp"

namespace cdsm::io {

/// Not empty.
std::string requiredText(const TableReader& reader, const char* key);

/// `position`, `rotation` and `scale`, or `matrix`. Throws Error where both are given, for a scale of 0 and for a
/// rotation without an axis; what else keeps the transform from having an inverse is for validate() to find.
glm::mat4 readTransform(const TableReader& reader);

ShadowRole readShadowRole(const TableReader& reader);

/// The index of the object that the key names.
template <typename Object>
int indexOf(const TableReader& reader, const char* key, const std::vector<Object>& objects, const char* kind) {
  const std::string wanted = reader.text(key, "");
  std::vector<std::string> names;
  for (const Object& object : objects) {
    if (object.name == wanted) return static_cast<int>(names.size());
    names.push_back(object.name);
  }
  reader.fail(key, std::string("unknown ") + kind + " '" + wanted + "'" + suggestion(wanted, names));
}

}  // namespace cdsm::io
