// SPDX-License-Identifier: Apache-2.0
// Meshes and spheres. Their data are copied once, when they are given; what they give back is a view of that.
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

/// A view of an array of three columns; None without data.
template <class Number, class Data, class Row>
py::object rowsView(const std::shared_ptr<const Data>& data, std::vector<Row> Data::*rows) {
  if (!data || (*data.*rows).empty()) return py::none();
  const std::vector<Row>& list = *data.*rows;
  return viewOf<Number>(&list.data()->x, {py::ssize_t(list.size()), 3}, data);
}

template <class Number, class Object, class Access, class Data, class Row>
void addRows(Fields<Object>& fields, const char* name, Access access, std::vector<Row> Data::*rows, const char* doc) {
  const std::string what = std::string(name) + " are";
  fields.property(
      name, [access, rows](Object& object) { return rowsView<Number>(access(object), rows); },
      [access, rows, what](Object& object, const py::object& given) {
        std::vector<Row> list;
        if (!given.is_none()) list = rowsOf<Row, Number>(given, 3, what);
        replace(access(object), [&](Data& data) { data.*rows = std::move(list); });
      },
      doc);
}

py::object radiiView(SpheresObject& object) {
  const std::shared_ptr<const SphereData>& data = object.spheres.data;
  if (!data || data->radii.empty()) return py::none();
  return viewOf<float>(data->radii.data(), {py::ssize_t(data->radii.size())}, data);
}

void setRadii(SpheresObject& object, const py::object& given) {
  std::vector<float> radii = rowsOf<float, float>(given, 1, "radii are");
  replace(object.spheres.data, [&](SphereData& data) { data.radii = std::move(radii); });
}

}  // namespace

void bindMesh(py::module_& module) {
  Fields<MeshObject> fields(module, "Mesh", "Triangles with a matrix and a material. Arrays are copied when given.");
  const auto data = [](MeshObject& m) -> std::shared_ptr<const MeshData>& { return m.mesh.data; };
  addRows<float>(fields, "positions", data, &MeshData::positions, "Object space: float32 of shape (n, 3).");
  addRows<float>(fields, "normals", data, &MeshData::normals, "None, or one per position: float32 of shape (n, 3).");
  addRows<std::uint32_t>(fields, "triangles", data, &MeshData::triangles, "Indices: uint32 of shape (n, 3).");
  fields
      .field(
          "name", [](MeshObject& m) -> std::string& { return m.mesh.name; }, "For messages and statistics.")
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
  Fields<SpheresObject> fields(module, "Spheres", "Spheres with radii of their own. Arrays are copied when given.");
  const auto data = [](SpheresObject& s) -> std::shared_ptr<const SphereData>& { return s.spheres.data; };
  addRows<float>(fields, "centers", data, &SphereData::centers, "Object space: float32 of shape (n, 3).");
  addRows<float>(fields, "colors", data, &SphereData::colors, "None, or one per centre: float32 of shape (n, 3).");
  fields.property("radii", radiiView, setRadii, "One per centre, above 0: float32 of shape (n,).")
      .field(
          "name", [](SpheresObject& s) -> std::string& { return s.spheres.name; }, "For messages and statistics.")
      .field("material", &SpheresObject::material, "None: the default one.")
      .field(
          "world_from_object", [](SpheresObject& s) -> glm::mat4& { return s.spheres.worldFromObject; },
          "4 x 4; scales all axes alike.");
  addShadowRole(fields, [](SpheresObject& s) -> ShadowRole& { return s.spheres.shadow; });
  fields.constructor();
}

}  // namespace cdsm::python
