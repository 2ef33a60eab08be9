// SPDX-License-Identifier: BSD-3-Clause
#include "ObjectText.h"

#include "Bindings.h"

namespace perilymph::python {

py::str htmlTable(const std::string& title,
                  const std::vector<std::pair<std::string, std::string>>& rows)
{
  const py::object escape = py::module_::import("html").attr("escape");
  const auto escaped = [&](const std::string& text) {
    return escape(textOf(text)).cast<std::string>();
  };
  std::string html = "<table><caption>" + escaped(title) + "</caption>";
  for (const auto& [name, value] : rows)
    html += "<tr><th>" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>";
  return textOf(html + "</table>");
}

py::dict dictOfRenamed() { return py::module_::import("perilymph._tables").attr("Renamed")(); }

py::bytes bytesOf(const py::object& values)
{
  return py::module_::import("perilymph._tables").attr("bytes_of")(values);
}

const py::array& locked(const py::array& values)
{
  values.attr("setflags")(py::arg("write") = false);
  return values;
}

const py::dict& locked(const py::dict& columns)
{
  for (const auto& [name, values] : columns)
    if (py::isinstance<py::array>(values)) locked(py::reinterpret_borrow<py::array>(values));
  return columns;
}

py::dict ownDict(const py::dict& columns) { return columns.attr("copy")(); }

py::dict copied(const py::dict& columns)
{
  return py::module_::import("copy").attr("deepcopy")(columns);
}

py::object dataFrameOf(const py::dict& columns)
{
  return py::module_::import("perilymph._tables").attr("data_frame")(columns);
}

}  // namespace perilymph::python
