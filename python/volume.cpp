// SPDX-License-Identifier: Apache-2.0
// Volumes, whose voxels stay in the array that they are in, and transfer functions.
#include <utility>

#include "arrays.hpp"
#include "objects.hpp"

namespace cdsm::python {

namespace {

VoxelType voxelTypeOf(const py::array& array) {
  const std::pair<py::dtype, VoxelType> types[] = {{py::dtype::of<std::uint8_t>(), VoxelType::UInt8},
                                                   {py::dtype::of<std::int8_t>(), VoxelType::Int8},
                                                   {py::dtype::of<std::uint16_t>(), VoxelType::UInt16},
                                                   {py::dtype::of<std::int16_t>(), VoxelType::Int16},
                                                   {py::dtype::of<float>(), VoxelType::Float32}};
  for (const auto& [type, voxels] : types)
    if (array.dtype().equal(type)) return voxels;
  throw Error("voxels are " + typeName(array.dtype()) +
              ", must be uint8, int8, uint16, int16 or float32 in this machine's byte order");
}

std::shared_ptr<const VolumeData> dataOf(const py::array& array, const glm::mat4& objectFromIndex) {
  auto data = std::make_shared<VolumeData>();
  data->type = voxelTypeOf(array);
  checkShape(array, {-1, -1, -1}, "voxels are");
  for (int axis = 0; axis < 3; ++axis) {  // NumPy's last axis is x
    const py::ssize_t voxels = array.shape(2 - axis);
    if (voxels > 0xffffffffll) throw Error("voxels are of shape " + shapeOf(array) + ", which is too many");
    data->size[axis] = glm::uint(voxels);
    data->view.strides[std::size_t(axis)] = array.strides(2 - axis);
  }
  if (data->view.strides == std::array<std::ptrdiff_t, 3>{0, 0, 0} && array.size() > 1)
    throw Error(
        "voxels are one value again and again, must lie in memory; numpy.ascontiguousarray() makes such a copy");
  data->objectFromIndex = objectFromIndex;
  data->view.data = array.data();
  data->view.owner = ownerOf(array);
  return data;
}

glm::mat4 indexMatrix(const VolumeObject& object) {
  return object.volume.data ? object.volume.data->objectFromIndex : glm::mat4(1.0f);
}

void setVoxels(VolumeObject& object, const py::object& given) {
  const py::array array = arrayOf(given, "voxels are");
  object.volume.data = dataOf(array, indexMatrix(object));
  object.voxels = array;
}

void setIndexMatrix(VolumeObject& object, const py::object& given) {
  auto data = object.volume.data ? std::make_shared<VolumeData>(*object.volume.data) : std::make_shared<VolumeData>();
  data->objectFromIndex = valueOf<glm::mat4>(given, "Volume.object_from_index");
  object.volume.data = data;
}

/// Rows of numbers from anything that NumPy makes an array of.
py::array_t<float> pointsOf(const py::object& given, py::ssize_t columns, const std::string& what) {
  const auto points = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!points)
    throw py::type_error(what + " no rows of numbers, must be of shape (n, " + std::to_string(columns) + ")");
  if (points.size() == 0) return py::array_t<float>(std::vector<py::ssize_t>{0, columns});
  checkShape(points, {-1, columns}, what);
  return points;
}

py::tuple rowOf(const TransferFunction::OpacityPoint& p) { return py::make_tuple(p.value, p.opacity); }
py::tuple rowOf(const TransferFunction::ColorPoint& p) {
  return py::make_tuple(p.value, p.color.r, p.color.g, p.color.b);
}

using Rows = py::array_t<float>;

void takeRow(TransferFunction::OpacityPoint& p, const Rows& rows, py::ssize_t i) { p = {rows.at(i, 0), rows.at(i, 1)}; }
void takeRow(TransferFunction::ColorPoint& p, const Rows& rows, py::ssize_t i) {
  p = {rows.at(i, 0), {rows.at(i, 1), rows.at(i, 2), rows.at(i, 3)}};
}

/// A list of points as rows of so many numbers.
template <class Point>
Fields<TransferFunction>& addPoints(Fields<TransferFunction>& fields, const char* name, py::ssize_t columns,
                                    std::vector<Point> TransferFunction::*points, const char* doc) {
  return fields.property(
      name,
      [points](TransferFunction& t) {
        py::list rows;
        for (const Point& point : t.*points) rows.append(rowOf(point));
        return py::tuple(rows);
      },
      [points, columns, what = "TransferFunction." + std::string(name) + " is"](TransferFunction& t,
                                                                                const py::object& given) {
        const Rows rows = pointsOf(given, columns, what);
        std::vector<Point> list(std::size_t(rows.shape(0)));
        for (std::size_t i = 0; i < list.size(); ++i) takeRow(list[i], rows, py::ssize_t(i));
        t.*points = std::move(list);
      },
      doc);
}

void bindTransferFunction(py::module_& module) {
  Fields<TransferFunction> fields(module, "TransferFunction",
                                  "Opacity and colour by value: linear between the points, constant outside.");
  addPoints(fields, "opacity", 2, &TransferFunction::opacity, "Rows of (value, opacity per unit_distance).");
  addPoints(fields, "shadow_opacity", 2, &TransferFunction::shadowOpacity,
            "In place of `opacity` where light is attenuated; empty: the same.");
  addPoints(fields, "color", 4, &TransferFunction::color, "Rows of (value, red, green, blue).");
  addPoints(fields, "transmission", 4, &TransferFunction::transmission,
            "What of the light's colour gets through where the volume interacts: rows of (value, red, green, blue); "
            "empty: nothing.")
      .field("unit_distance", &TransferFunction::unitDistance, "World length for which the opacities hold, above 0.")
      .constructor();
}

}  // namespace

void bindVolume(py::module_& module) {
  bindTransferFunction(module);
  Fields<VolumeObject> fields(module, "Volume", "Voxels, used in place, with a transfer function.");
  fields
      .property(
          "voxels", [](VolumeObject& v) { return v.voxels; }, setVoxels,
          "Array of shape (z, y, x), uint8, int8, uint16, int16 or float32, strided or not. It is kept and read "
          "in place; after writing to it, count `revision` up.")
      .property(
          "object_from_index", [](VolumeObject& v) { return py::cast(indexMatrix(v)); }, setIndexMatrix,
          "4 x 4, from the index (x, y, z) of a voxel's centre to object space.")
      .field(
          "name", [](VolumeObject& v) -> std::string& { return v.volume.name; }, "For messages and statistics.")
      .field(
          "revision", [](VolumeObject& v) -> std::uint64_t& { return v.volume.revision; },
          "Another one than before says that the voxels of the same array have changed.")
      .field("transfer", &VolumeObject::transfer, "Opacity and colour by value.")
      .field("boundary", &VolumeObject::boundary, "None, or a closed mesh of the scene that cuts the volume.")
      .field(
          "world_from_object", [](VolumeObject& v) -> glm::mat4& { return v.volume.worldFromObject; }, "4 x 4.")
      .field(
          "specular", [](VolumeObject& v) -> glm::vec3& { return v.volume.specular; }, "Linear RGB.")
      .field(
          "shininess", [](VolumeObject& v) -> float& { return v.volume.shininess; }, "Exponent of the highlight.")
      .field(
          "shading", [](VolumeObject& v) -> bool& { return v.volume.shading; },
          "Phong with the gradient as normal; False: the colour as it is, times the light.");
  addShadowRole(fields, [](VolumeObject& v) -> ShadowRole& { return v.volume.shadow; });
  fields.constructor();
}

}  // namespace cdsm::python
