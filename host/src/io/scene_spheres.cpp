// SPDX-License-Identifier: Apache-2.0
// [[spheres]] of a scene file.
#include <string>

#include "io/object_keys.hpp"
#include "io/scene_keys.hpp"
#include "io/scene_parts.hpp"
#include "scene/range.hpp"
#include "scene/validate.hpp"

namespace cdsm::io {
namespace {

const Choices kColors{"element"};
std::optional<glm::vec3> readColor(const TableReader& reader) {
  if (reader.has("color") && !reader.table().get("color")->is_string())
    return reader.vector("color", glm::vec3(1.0f), scene::kNotNegative);
  reader.choice("color", "element", kColors);
  return std::nullopt;
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
  reader.number("scale", 1.0f, scene::kCoordinate);  // one number, as spheres stay spheres
  spheres.worldFromObject = readTransform(reader);
  spheres.shadow = readShadowRole(reader);
  reader.locate("file", [&] { spheres.data = assets.spheres(file, look); });
  reader.locate(reader.has("matrix") ? "matrix" : "file",
                [&] { scene::validateSpheres(spheres, scene.materials.size(), assets.checks()); });
  return spheres;
}

}  // namespace cdsm::io
