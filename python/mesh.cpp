// SPDX-License-Identifier: Apache-2.0
// Meshes and spheres, whose arrays stay where they are.
#include "arrays.hpp"
#include "objects.hpp"

namespace cdsm::python {

namespace {

/// Changes the data of an object by replacing it: the engine tells by the pointer that there is something new.
template <class Data, class Change>
void replace(std::shared_ptr<const Data>& data, Change change) {
  auto next = data ? std::make_shared<Data>(*data) : std::make_shared<Data>();
  change(*next);
  data = next;
}

/// An array of rows as attribute. `kept`: the array that was given, of which `rows` is a view.
template <class Number, class Object, class Access, class Data, class Row>
void addRows(Fields<Object>& fields, const char* name, Access access, Array<Row> Data::*rows, py::object Object::*kept,
             const char* doc) {
  const std::string what = std::string(name) + " are";
  fields.property(
      name, [kept](Object& object) { return object.*kept; },
      [access, rows, kept, what](Object& object, const py::object& given) {
        Array<Row> view;
        if (!given.is_none()) view = rowsOf<Row, Number>(arrayOf(given, what), what);
        replace(access(object), [&](Data& data) { data.*rows = view; });
        object.*kept = given;
      },
      doc);
}

constexpr const char* kRevision = "Another one than before says that values of the same arrays have changed.";

}  // namespace

void bindMesh(py::module_& module) {
  Fields<MeshObject> fields(
      module, "Mesh",
      "Triangles with a matrix and a material. Arrays are kept and read in place; after writing to one, count "
      "`revision` up.");
  const auto data = [](MeshObject& m) -> std::shared_ptr<const MeshData>& { return m.mesh.data; };
  addRows<float>(fields, "positions", data, &MeshData::positions, &MeshObject::positions,
                 "Object space: float32 of shape (n, 3).");
  addRows<float>(fields, "normals", data, &MeshData::normals, &MeshObject::normals,
                 "None, or one per position: float32 of shape (n, 3).");
  addRows<std::uint32_t>(fields, "triangles", data, &MeshData::triangles, &MeshObject::triangles,
                         "Indices: uint32 of shape (n, 3).");
  fields
      .field(
          "name", [](MeshObject& m) -> std::string& { return m.mesh.name; }, "For messages and statistics.")
      .field(
          "revision", [](MeshObject& m) -> std::uint64_t& { return m.mesh.revision; }, kRevision)
      .field("material", &MeshObject::material, "None: the default one.")
      .field(
          "world_from_object", [](MeshObject& m) -> glm::mat4& { return m.mesh.worldFromObject; }, "4 x 4.")
      .field(
          "interior_extinction", [](MeshObject& m) -> float& { return m.mesh.interiorExtinction; },
          "1 / world length; above 0 needs a closed mesh.")
      .field(
          "interior_color", [](MeshObject& m) -> glm::vec3& { return m.mesh.interiorColor; }, "Linear RGB.")
      .field(
          "interior_transmission", [](MeshObject& m) -> glm::vec3& { return m.mesh.interiorTransmission; },
          "What of the light's colour gets through where the interior interacts.");
  addShadowRole(fields, [](MeshObject& m) -> ShadowRole& { return m.mesh.shadow; });
  fields.constructor();
}

void bindSpheres(py::module_& module) {
  Fields<SpheresObject> fields(
      module, "Spheres",
      "Spheres with radii of their own. Arrays are kept and read in place; after writing to one, count "
      "`revision` up.");
  const auto data = [](SpheresObject& s) -> std::shared_ptr<const SphereData>& { return s.spheres.data; };
  addRows<float>(fields, "centers", data, &SphereData::centers, &SpheresObject::centers,
                 "Object space: float32 of shape (n, 3).");
  addRows<float>(fields, "colors", data, &SphereData::colors, &SpheresObject::colors,
                 "None, or one per centre: float32 of shape (n, 3).");
  addRows<float>(fields, "radii", data, &SphereData::radii, &SpheresObject::radii,
                 "One per centre, above 0: float32 of shape (n,).");
  fields
      .field(
          "name", [](SpheresObject& s) -> std::string& { return s.spheres.name; }, "For messages and statistics.")
      .field(
          "revision", [](SpheresObject& s) -> std::uint64_t& { return s.spheres.revision; }, kRevision)
      .field("material", &SpheresObject::material, "None: the default one.")
      .field(
          "world_from_object", [](SpheresObject& s) -> glm::mat4& { return s.spheres.worldFromObject; },
          "4 x 4; scales all axes alike.");
  addShadowRole(fields, [](SpheresObject& s) -> ShadowRole& { return s.spheres.shadow; });
  fields.constructor();
}

}  // namespace cdsm::python
