// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How objects compare and show themselves in Python.

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
          "Equal objects have the same.");
}

}  // namespace perilymph::python
