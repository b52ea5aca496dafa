// SPDX-License-Identifier: Apache-2.0
// Finished maps: their values are arrays over the map's own memory.
#include <cdsm/light_map.hpp>

#include "arrays.hpp"
#include "objects.hpp"

namespace cdsm::python {

namespace {

using Map = std::shared_ptr<LightMap>;

py::array firstNodes(const Map& map) {
  return viewOf<std::uint32_t>(map->firstNode.data(), {py::ssize_t(map->firstNode.size())}, map);
}

py::array nodes(const Map& map) {
  static_assert(sizeof(MapNode) == 2 * sizeof(float), "a node is a row of two floats");
  return viewOf<float>(&map->nodes.data()->depth, {py::ssize_t(map->nodes.size()), 2}, map);
}

py::object colors(const Map& map) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "transmittances of a node are a row of three floats");
  if (map->colors.empty()) return py::none();
  return viewOf<float>(&map->colors.data()->x, {py::ssize_t(map->colors.size()), 3}, map);
}

}  // namespace

void bindLightMap(py::module_& module) {
  py::class_<LightMap, Map>(
      module, "LightMap",
      "One deep shadow map of a light; those of its clusters are multiplied. Between two nodes of "
      "a texel transmittance is linear in depth, in front of the first 1, behind the last constant.")
      .def_readonly("cluster", &LightMap::cluster)
      .def_readonly("number", &LightMap::number, "Among the maps of its cluster.")
      .def_readonly("objects", &LightMap::objects, "Names of what casts in it.")
      .def_readonly("side", &LightMap::side, "Of an omni light: '+x', '-x' ... '-z', the only points looked up in it.")
      .def_readonly("share", &LightMap::share, "Of the set of maps with this share in the light.")
      .def_readonly("width", &LightMap::width, "Texels.")
      .def_readonly("height", &LightMap::height, "Texels.")
      .def_readonly("near_depth", &LightMap::nearDepth, "Nothing in front of it attenuates.")
      .def_readonly("far_depth", &LightMap::farDepth, "Of what casts in it.")
      .def_property_readonly(
          "picture_from_world", [](const LightMap& map) { return map.pictureFromWorld; },
          "Homogeneous: x / w and y / w in [0, 1] from the top left, z / w from near to far.")
      .def_property_readonly(
          "camera_from_world", [](const LightMap& map) { return map.cameraFromWorld; },
          "Left-handed: x to the right, y upwards, z is the depth.")
      .def_property_readonly("first_node", firstNodes,
                             "uint32: of texel y * width + x; one more at the end. Not copied.")
      .def_property_readonly("nodes", nodes, "float32 of shape (n, 2): depth and transmittance. Not copied.")
      .def_property_readonly("colors", colors,
                             "float32 of shape (n, 3): of each node the transmittances of red, green and blue light, "
                             "of which `nodes` has the mean; None where transmittance is grey. Not copied.");
}

}  // namespace cdsm::python
