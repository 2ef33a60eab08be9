// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "Bindings.h"
#include "NumberArrays.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::python {

namespace {

using electrode::ArrayDesign;

ArrayDesign readArray(const py::object& given)
{
  const std::string name = nameOrFileOf(given, "array");
  return valueOf(withoutLock([&]() -> Result<ArrayDesign> {
    const auto file = findByName("array", "plugins/electrodes", name);
    if (!file) return file.error();
    return electrode::loadArray(*file);
  }));
}

py::array inMillimeters(const std::vector<Length>& lengths)
{
  std::vector<double> values;
  values.reserve(lengths.size());
  for (const Length each : lengths) values.push_back(perilymph::inMillimeters(each));
  return arrayOf(std::move(values));
}

/// A quantity at distances from the tip.
template <class Quantity>
py::array along(const ArrayDesign& array, const py::object& from_tip_mm, const Quantity& quantity)
{
  const double length_mm = perilymph::inMillimeters(array.length);
  return mapped(numbersOf(from_tip_mm, "from_tip_mm", "mm", 0.0, length_mm),
                [&](double place) { return quantity(millimeters(place)); });
}

py::list sources(const ArrayDesign& array)
{
  constexpr const char* names[] = {"high", "medium", "low"};
  py::list rows;
  for (const auto& [table, source] : array.provenance)
    rows.append(py::make_tuple(textOf(table), textOf(source.source),
                               names[static_cast<std::size_t>(source.confidence)]));
  return rows;
}

}  // namespace

void defineArrays(py::module_& module)
{
  py::class_<ArrayDesign>(
      module, "Array",
      "An electrode array as its file describes it. Places are distances from the tip [mm]; values "
      "between the file's are linear. Not device labeling.")
      .def_property_readonly(
          "name", [](const ArrayDesign& one) { return textOf(one.name); }, "\"FLEX28\".")
      .def_property_readonly(
          "maker", [](const ArrayDesign& one) { return textOf(one.maker); }, "The maker's name.")
      .def_property_readonly(
          "note", [](const ArrayDesign& one) { return textOf(one.note); },
          "Where the values come from, for the user.")
      .def_property_readonly(
          "length_mm", [](const ArrayDesign& one) { return perilymph::inMillimeters(one.length); },
          "From the tip to the grip of the tweezers [mm].")
      .def_property_readonly(
          "insertable_mm",
          [](const ArrayDesign& one) { return perilymph::inMillimeters(one.insertable); },
          "Maximum depth past the opening [mm].")
      .def_property_readonly(
          "contacts_from_tip_mm",
          [](const ArrayDesign& one) { return inMillimeters(one.contactsFromTip); },
          "Centers of the contacts from the tip, shape (n,) [mm].")
      .def_property_readonly(
          "contact_length_mm",
          [](const ArrayDesign& one) { return perilymph::inMillimeters(one.contactLength); },
          "Length of one contact along the array [mm].")
      .def_property_readonly(
          "ribs_from_tip_mm", [](const ArrayDesign& one) { return inMillimeters(one.ribsFromTip); },
          "Centers of the marker ribs from the tip, shape (n,) [mm].")
      .def_readonly("has_stylet", &ArrayDesign::hasStylet, "Whether it has a stylet or sheath.")
      .def_property_readonly("sources", &sources,
                             "(table of the file, source, confidence 'high', 'medium' or 'low').")
      .def(
          "width_mm",
          [](const ArrayDesign& one, const py::object& from_tip_mm) {
            return along(one, from_tip_mm, [&](Length place) {
              return perilymph::inMillimeters(one.sectionAt(place).across);
            });
          },
          py::arg("from_tip_mm"),
          "Diameter across the plane of curl at places (...) [mm], with the taper of the tip and "
          "without ribs.")
      .def(
          "thickness_mm",
          [](const ArrayDesign& one, const py::object& from_tip_mm) {
            return along(one, from_tip_mm, [&](Length place) {
              return perilymph::inMillimeters(one.sectionAt(place).within);
            });
          },
          py::arg("from_tip_mm"), "Diameter within the plane of curl at places (...) [mm].")
      .def(
          "bending_stiffness_Nm2",
          [](const ArrayDesign& one, const py::object& from_tip_mm) {
            return along(one, from_tip_mm,
                         [&](Length place) { return one.bending.at(place).si(); });
          },
          py::arg("from_tip_mm"),
          "Bending stiffness EI of the carrier within the plane of curl at places (...) [N m^2], "
          "without stylet.")
      .def(
          "bending_stiffness_across_Nm2",
          [](const ArrayDesign& one, const py::object& from_tip_mm) {
            return along(one, from_tip_mm,
                         [&](Length place) { return one.bendingAcrossAt(place).si(); });
          },
          py::arg("from_tip_mm"), "EI across the plane of curl at places (...) [N m^2].")
      .def(
          "torsional_stiffness_Nm2",
          [](const ArrayDesign& one, const py::object& from_tip_mm) {
            return along(one, from_tip_mm,
                         [&](Length place) { return one.twistingAt(place).si(); });
          },
          py::arg("from_tip_mm"), "Torsional stiffness GJ at places (...) [N m^2].")
      .def(
          "rest_curvature_per_mm",
          [](const ArrayDesign& one, const py::object& from_tip_mm) {
            return along(one, from_tip_mm, [&](Length place) {
              return inPerMillimeter(one.restCurvature.at(place));
            });
          },
          py::arg("from_tip_mm"),
          "Curvature of the free carrier without stylet at places (...) [1/mm]; 0: straight.")
      .def("__repr__",
           [](const ArrayDesign& one) { return textOf("<perilymph.Array '" + one.name + "'>"); });

  module.def(
      "arrays", [] { return shippedNames("plugins/electrodes"); },
      "Names of the shipped electrode arrays.");
  module.def("read_array", &readArray, py::arg("name_or_file"),
             "Reads an electrode array: a shipped name, or a TOML file.");
}

}  // namespace perilymph::python
