// SPDX-License-Identifier: Apache-2.0
// Vectors and matrices of the public headers as Python sees them: tuples of three, arrays of 4 x 4.
#pragma once

#include <cstddef>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <glm/glm.hpp>

namespace pybind11::detail {

/// From any sequence of three numbers; to a tuple, whose parts cannot be set: a change would not reach the scene.
template <>
struct type_caster<glm::vec3> {
  PYBIND11_TYPE_CASTER(glm::vec3, const_name("tuple[float, float, float]"));

  bool load(handle source, bool) {
    if (PySequence_Check(source.ptr()) == 0) return false;
    const Py_ssize_t size = PySequence_Size(source.ptr());
    if (size < 0) PyErr_Clear();
    if (size != 3) return false;
    for (int i = 0; i < 3; ++i) {
      make_caster<float> number;
      if (!number.load(reinterpret_borrow<sequence>(source)[std::size_t(i)], true)) return false;
      value[i] = cast_op<float>(number);
    }
    return true;
  }

  static handle cast(const glm::vec3& v, return_value_policy, handle) { return make_tuple(v.x, v.y, v.z).release(); }
};

/// Rows and columns as in NumPy, where M @ (x, y, z, 1) maps a point; glm counts columns first. Read-only in Python.
template <>
struct type_caster<glm::mat4> {
  PYBIND11_TYPE_CASTER(glm::mat4, const_name("numpy.ndarray"));

  bool load(handle source, bool) {
    const auto matrix = array_t<float, array::c_style | array::forcecast>::ensure(source);
    if (!matrix || matrix.ndim() != 2 || matrix.shape(0) != 4 || matrix.shape(1) != 4) return false;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) value[column][row] = matrix.at(row, column);
    return true;
  }

  static handle cast(const glm::mat4& m, return_value_policy, handle) {
    array_t<float> matrix({4, 4});
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) matrix.mutable_at(row, column) = m[column][row];
    array_proxy(matrix.ptr())->flags &= ~npy_api::NPY_ARRAY_WRITEABLE_;
    return matrix.release();
  }
};

}  // namespace pybind11::detail
