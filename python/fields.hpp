// SPDX-License-Identifier: Apache-2.0
// Python classes of plain values: attributes that say what they must be, and a constructor that takes them by keyword.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "casters.hpp"

namespace cdsm::python {

namespace py = pybind11;

template <class Value>
struct Expected;  ///< what a value of this type must be, in words
template <>
struct Expected<float> {
  static std::string text() { return "a number"; }
};
template <>
struct Expected<int> {
  static std::string text() { return "an integer"; }
};
template <>
struct Expected<std::uint64_t> {
  static std::string text() { return "an integer of at least 0"; }
};
template <>
struct Expected<bool> {
  static std::string text() { return "True or False"; }
};
template <>
struct Expected<std::string> {
  static std::string text() { return "a string"; }
};
template <>
struct Expected<glm::vec3> {
  static std::string text() { return "three numbers"; }
};
template <>
struct Expected<glm::mat4> {
  static std::string text() { return "a matrix of 4 x 4 numbers"; }
};
template <class T>
struct Expected<std::shared_ptr<T>> {
  static std::string text() { return "a cdsm." + py::type::of<T>().attr("__name__").template cast<std::string>(); }
};

/// A Python value as C++ has it. Throws TypeError: "WHAT is 'abc', must be a number".
template <class Value>
Value valueOf(const py::handle& given, const std::string& what) {
  try {
    return given.cast<Value>();
  } catch (const py::cast_error&) {
    std::string shown = py::repr(given);
    if (shown.size() > 60) shown = "of type " + py::type::of(given).attr("__name__").cast<std::string>();
    throw py::type_error(what + " is " + shown + ", must be " + Expected<Value>::text());
  }
}

template <class T>
class Fields {
 public:
  using Get = std::function<py::object(T&)>;
  using Set = std::function<void(T&, const py::object&)>;

  Fields(py::module_& module, const char* name, const char* doc) : type_(module, name, doc), name_(name) {}

  /// An attribute that is read and written through `access`, a member or a function that gives a reference.
  template <class Access>
  Fields& field(const char* name, Access access, const char* doc) {
    using Value = std::decay_t<std::invoke_result_t<Access, T&>>;
    return property(
        name, [access](T& object) { return py::cast(Value(std::invoke(access, object))); },
        [access, what = name_ + "." + name](T& object, const py::object& given) {
          std::invoke(access, object) = valueOf<Value>(given, what);
        },
        doc);
  }

  Fields& property(const char* name, Get get, Set set, const char* doc) {
    (*setters_)[name] = set;
    type_.def_property(name, py::cpp_function(std::move(get)), py::cpp_function(std::move(set)), doc);
    return *this;
  }

  /// Comes last.
  void constructor() {
    const auto make = [setters = setters_, name = name_](const py::kwargs& given) {
      auto object = std::make_shared<T>();
      for (const auto& [key, value] : given) assign(*object, *setters, name, key.template cast<std::string>(), value);
      return object;
    };
    type_.def(py::init(make), "Attributes by keyword; those left out have their defaults.");
  }

 private:
  using Setters = std::map<std::string, Set>;

  static void assign(T& object, const Setters& setters, const std::string& type, const std::string& key,
                     py::handle value) {
    const auto found = setters.find(key);
    if (found != setters.end()) return found->second(object, py::reinterpret_borrow<py::object>(value));
    std::string known;
    for (const auto& [name, setter] : setters) known += (known.empty() ? "" : ", ") + name;
    throw py::type_error(type + " has no '" + key + "'; known: " + known);
  }

  py::class_<T, std::shared_ptr<T>> type_;
  std::string name_;
  std::shared_ptr<Setters> setters_ = std::make_shared<Setters>();
};

}  // namespace cdsm::python
