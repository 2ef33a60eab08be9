// SPDX-License-Identifier: BSD-3-Clause
#include "ContactColumns.h"

#include <limits>

#include "NumberArrays.h"

namespace perilymph::python {

py::dict contactColumns(const std::vector<analysis::ContactPosition>& contacts)
{
  using Contact = analysis::ContactPosition;
  py::dict table;
  const auto add = [&](const char* name, bool needsInsertion, const auto& value) {
    std::vector<double> values;
    for (const Contact& each : contacts)
      values.push_back(needsInsertion && !each.isInserted ? std::numeric_limits<double>::quiet_NaN()
                                                          : value(each));
    table[name] = arrayOf(std::move(values));
  };
  std::vector<std::int64_t> numbers;
  py::list inserted;
  for (const Contact& each : contacts) {
    numbers.push_back(each.number);
    inserted.append(each.isInserted);
  }
  table["number"] = arrayOf(std::move(numbers));
  table["is_inserted"] =
      py::module_::import("numpy").attr("array")(inserted, py::arg("dtype") = "bool");
  add("depth_mm", false, [](const Contact& one) { return inMillimeters(one.depth); });
  add("angle_deg", true, [](const Contact& one) { return inDegrees(one.angle); });
  add("coverage_percent", true, [](const Contact& one) { return 100.0 * one.coverage; });
  add("frequency_Hz", true, [](const Contact& one) { return one.frequency_Hz; });
  add("to_modiolus_mm", true, [](const Contact& one) {
    return one.toModiolus < Length() ? std::numeric_limits<double>::quiet_NaN()
                                     : inMillimeters(one.toModiolus);
  });
  return table;
}

}  // namespace perilymph::python
