// SPDX-License-Identifier: Apache-2.0
// NumPy arrays on their way in and out. What is not as it must be is refused, never converted in silence. `what` is the
// array with its verb, as messages begin: "points are".
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cdsm/array.hpp>
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

/// Keeps an array for the engine, which lets go of it on a thread that need not hold the interpreter's lock.
std::shared_ptr<const void> ownerOf(const py::array& array);

/// Rows of `Number`, of which `Row` is made, where the array has them. Rows may lie apart, numbers of a row may not.
template <class Row, class Number>
Array<Row> rowsOf(const py::array& array, const std::string& what) {
  static_assert(sizeof(Row) % sizeof(Number) == 0, "rows are numbers side by side");
  constexpr auto kColumns = py::ssize_t(sizeof(Row) / sizeof(Number));
  checkType(array, py::dtype::of<Number>(), what);
  checkShape(array, kColumns == 1 ? std::vector<py::ssize_t>{-1} : std::vector<py::ssize_t>{-1, kColumns}, what);
  if (kColumns > 1 && array.shape(0) > 0 && array.strides(1) != py::ssize_t(sizeof(Number)))
    throw Error(what +
                " rows whose numbers lie apart, must lie side by side; numpy.ascontiguousarray() makes such a copy");
  return Array<Row>::view(array.data(), std::size_t(array.shape(0)), array.strides(0), ownerOf(array));
}

}  // namespace cdsm::python
