// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How objects compare and show themselves in Python.

#include <pybind11/numpy.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "PythonErrors.h"

namespace perilymph::python {

/// A table of names and values in HTML, for notebooks; the texts are escaped.
py::str htmlTable(const std::string& title,
                  const std::vector<std::pair<std::string, std::string>>& rows);

/// Defines `==` and hash of a class.
///
/// @param identity  Text of an object, the same for equal objects only.
template <class Class, class... Options, class Identity>
void defineIdentity(py::class_<Class, Options...>& kind, const Identity& identity)
{
  kind.def(
          "__eq__",
          [identity](const Class& one, const py::object& other) -> py::object {
            if (!py::isinstance<Class>(other))
              return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(identity(one) == identity(other.cast<const Class&>()));
          },
          py::arg("other"), "Whether all values are the same.")
      .def(
          "__hash__", [identity](const Class& one) { return py::hash(py::bytes(identity(one))); },
          "Equal objects have the same.")
      .def(
          "__reduce_ex__",
          [](const py::object& one, int protocol) {
            // the first two protocols make an object without its class
            constexpr int first = 2;
            return py::module_::import("builtins")
                .attr("object")
                .attr("__reduce_ex__")(one, std::max(protocol, first));
          },
          py::arg("protocol"));
}

/// What the values of an object say, as bytes: of a tuple, dict, array, text or number, the same for equal
/// ones only.
py::bytes bytesOf(const py::object& values);

/// Makes the arrays of a dict read-only: those of an object that is compared and hashed by them.
const py::dict& locked(const py::dict& columns);
const py::array& locked(const py::array& values);

/// A dict that is the caller's own, with the same values.
py::dict ownDict(const py::dict& columns);

/// Columns that are the caller's own: with copies of the arrays.
py::dict copied(const py::dict& columns);

/// Defines what a mapping has: items by name, in order.
///
/// @param dictOf  The items of an object as a dict.
template <class Class, class... Options, class DictOf>
void defineMapping(py::class_<Class, Options...>& kind, const DictOf& dictOf)
{
  kind.def(
          "__getitem__",
          [dictOf](const Class& one, const std::string& name) -> py::object {
            return dictOf(one).attr("__getitem__")(name);
          },
          py::arg("name"), "A column by its name.")
      .def(
          "keys", [dictOf](const Class& one) { return py::list(dictOf(one)); },
          "Names of the columns.")
      .def(
          "values", [dictOf](const Class& one) { return py::list(dictOf(one).attr("values")()); },
          "The columns.")
      .def(
          "items", [dictOf](const Class& one) { return py::list(dictOf(one).attr("items")()); },
          "(name, column) of each column.")
      .def(
          "get",
          [dictOf](const Class& one, const py::object& name, const py::object& missing) {
            return py::object(dictOf(one).attr("get")(name, missing));
          },
          py::arg("name"), py::arg("default") = py::none(),
          "A column by its name, or `default` where there is none.")
      .def(
          "__len__", [dictOf](const Class& one) { return dictOf(one).size(); },
          "Number of columns.")
      .def("__iter__", [dictOf](const Class& one) { return py::iter(dictOf(one)); })
      .def(
          "__contains__",
          [dictOf](const Class& one, const py::object& name) { return dictOf(one).contains(name); },
          py::arg("name"));
  py::module_::import("collections.abc").attr("Mapping").attr("register")(kind);
}

}  // namespace perilymph::python
