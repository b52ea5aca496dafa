// SPDX-License-Identifier: Apache-2.0
// NumPy arrays on their way in and out. What is not as it must be is refused, never converted in silence. `what` is the
// array with its verb, as messages begin: "points are".
#pragma once

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <cdsm/error.hpp>

#include "casters.hpp"

namespace cdsm::python {

namespace py = pybind11;

/// Throws Error if it is no array.
py::array arrayOf(const py::handle& given, const std::string& what);

/// "float32".
std::string typeName(const py::dtype& type);

/// "(2, 3)".
std::string shapeOf(const py::array& array);

/// Throws Error unless the numbers are of this type, in this machine's byte order.
void checkType(const py::array& array, const py::dtype& type, const std::string& what);

/// Throws Error unless the array has this shape, of which -1 stands for any number.
void checkShape(const py::array& array, const std::vector<py::ssize_t>& shape, const std::string& what);

/// Throws Error unless the numbers lie side by side, the last axis first, and are aligned.
void checkDense(const py::array& array, const std::string& what);

/// A float32 array to write results to: checked, or a new one where None is given.
py::array_t<float> resultArray(const py::object& given, const std::vector<py::ssize_t>& shape, const std::string& what);

/// Throws Error if results would be written to where input is read from.
void checkApart(const py::array& input, const py::array& results, const std::string& what);

/// An array over memory that `keep` holds.
template <class Number>
py::array_t<Number> arrayOver(const Number* first, const std::vector<py::ssize_t>& shape,
                              std::shared_ptr<const void> keep) {
  using Kept = std::shared_ptr<const void>;
  const py::capsule owner(new Kept(std::move(keep)), [](void* kept) { delete static_cast<Kept*>(kept); });
  return py::array_t<Number>(shape, first, owner);
}

/// The same, read-only.
template <class Number>
py::array viewOf(const Number* first, const std::vector<py::ssize_t>& shape, std::shared_ptr<const void> keep) {
  py::array_t<Number> array = arrayOver(first, shape, std::move(keep));
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return std::move(array);
}

/// A copy of an array of rows, strided or not: `Row` is made of `columns` of `Number`.
template <class Row, class Number>
std::vector<Row> rowsOf(const py::handle& given, int columns, const std::string& what) {
  const py::array array = arrayOf(given, what);
  checkType(array, py::dtype::of<Number>(), what);
  if (columns == 1)
    checkShape(array, {-1}, what);
  else
    checkShape(array, {-1, columns}, what);
  static_assert(sizeof(Row) % sizeof(Number) == 0, "rows are numbers side by side");
  const auto dense = py::array_t<Number, py::array::c_style>::ensure(array);
  std::vector<Row> rows(std::size_t(dense.shape(0)));
  if (!rows.empty()) std::memcpy(rows.data(), dense.data(), rows.size() * sizeof(Row));
  return rows;
}

}  // namespace cdsm::python
