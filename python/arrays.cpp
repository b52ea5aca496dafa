// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

#include <cstdint>

namespace cdsm::python {

namespace {

std::string shapeText(const py::ssize_t* shape, std::size_t size) {
  std::string text;
  for (std::size_t i = 0; i < size; ++i) text += (i ? ", " : "") + (shape[i] < 0 ? "n" : std::to_string(shape[i]));
  return "(" + text + (size == 1 ? ",)" : ")");
}

bool isAligned(const py::array& array) {
  return py::detail::check_flags(array.ptr(), py::detail::npy_api::NPY_ARRAY_ALIGNED_);
}

}  // namespace

py::array arrayOf(const py::handle& given, const std::string& what) {
  if (!py::isinstance<py::array>(given))
    throw Error(what + " of type " + py::type::of(given).attr("__name__").cast<std::string>() +
                ", must be a NumPy array");
  return py::reinterpret_borrow<py::array>(given);
}

std::string typeName(const py::dtype& type) { return py::str(static_cast<const py::object&>(type)); }

std::string shapeOf(const py::array& array) { return shapeText(array.shape(), std::size_t(array.ndim())); }

void checkType(const py::array& array, const py::dtype& type, const std::string& what) {
  if (!array.dtype().equal(type)) throw Error(what + " " + typeName(array.dtype()) + ", must be " + typeName(type));
}

void checkShape(const py::array& array, const std::vector<py::ssize_t>& shape, const std::string& what) {
  bool right = std::size_t(array.ndim()) == shape.size();
  for (std::size_t i = 0; right && i < shape.size(); ++i)
    right = shape[i] < 0 || array.shape(py::ssize_t(i)) == shape[i];
  if (!right)
    throw Error(what + " of shape " + shapeOf(array) + ", must be of shape " + shapeText(shape.data(), shape.size()));
}

void checkDense(const py::array& array, const std::string& what) {
  if ((array.flags() & py::array::c_style) == 0 || !isAligned(array))
    throw Error(what + " not C-contiguous and aligned, must be; numpy.ascontiguousarray() makes such a copy");
}

py::array_t<float> resultArray(const py::object& given, const std::vector<py::ssize_t>& shape,
                               const std::string& what) {
  if (given.is_none()) return py::array_t<float>(shape);
  const py::array array = arrayOf(given, what);
  checkType(array, py::dtype::of<float>(), what);
  checkShape(array, shape, what);
  checkDense(array, what);
  if (!array.writeable()) throw Error(what + " read-only, must be writable");
  return py::reinterpret_borrow<py::array_t<float>>(array);
}

void checkApart(const py::array& input, const py::array& results, const std::string& what) {
  const auto begin = [](const py::array& array) { return reinterpret_cast<std::uintptr_t>(array.data()); };
  // not array.nbytes(), by which pybind11 before 2.12 reads NumPy 2 in the wrong place
  const auto end = [&](const py::array& array) { return begin(array) + array.attr("nbytes").cast<std::uintptr_t>(); };
  if (begin(input) < end(results) && begin(results) < end(input))
    throw Error(what + " memory that is read from as well, must be an array of its own");
}

std::shared_ptr<const void> ownerOf(const py::array& array) {
  PyObject* const kept = py::object(array).release().ptr();
  return {array.data(), [kept](const void*) {
            if (Py_IsInitialized() == 0) return;
            const py::gil_scoped_acquire lock;
            Py_DECREF(kept);
          }};
}

}  // namespace cdsm::python
