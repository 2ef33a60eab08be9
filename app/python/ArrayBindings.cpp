// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <algorithm>
#include <set>

#include "Bindings.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "perilymph/electrode/ArrayText.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::python {

namespace {

using electrode::ArrayDesign;

Result<ArrayDesign> loadNamed(const std::string& name)
{
  const auto file = findByName("array", "plugins/electrodes", name);
  if (!file) return file.error();
  return electrode::loadArray(*file);
}

NamedArray readArray(const py::object& given)
{
  const std::string name = nameOrFileOf(given, "array");
  return {valueOf(withoutLock([&] { return loadNamed(name); })), name};
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

py::list sources(const NamedArray& one)
{
  constexpr const char* names[] = {"high", "medium", "low"};
  py::list rows;
  for (const auto& [table, source] : one.design.provenance)
    rows.append(py::make_tuple(textOf(table), textOf(source.source),
                               names[static_cast<std::size_t>(source.confidence)]));
  return rows;
}

py::dict knots(const ArrayDesign& array)
{
  py::dict found;
  found["width_mm"] = inMillimeters(array.diameter.fromTip);
  found["bending_stiffness_Nm2"] = inMillimeters(array.bending.fromTip);
  found["rest_curvature_per_mm"] = inMillimeters(array.restCurvature.fromTip);
  return found;
}

/// "0.50 to 0.80 mm wide".
std::string widths(const ArrayDesign& array)
{
  const auto [low, high] =
      std::minmax_element(array.diameter.value.begin(), array.diameter.value.end());
  return figures::fixed(perilymph::inMillimeters(*low), 2) + " to " +
         figures::fixed(perilymph::inMillimeters(*high), 2) + " mm wide";
}

/// A quantity along the array as given: a number, or places and values.
template <class Value, class Unit>
electrode::AlongArray<Value> alongOf(const py::object& given, const char* name, const char* unit,
                                     const Unit& quantity)
{
  constexpr double anything = 1e6;  // ranges are those of the file, checked with it
  const auto refused = [&] {
    return EngineError(std::string(name) +
                       " must be a number, or a pair of places from the tip [mm] and as many "
                       "values there. Give one of these.");
  };
  electrode::AlongArray<Value> found;
  NumberArray places{{1}, {0.0}}, values;
  const bool isNumber = PyNumber_Check(given.ptr()) != 0 && PySequence_Check(given.ptr()) == 0;
  if (isNumber) {
    values = numbersOf(given, name, unit, -anything, anything);
  } else {
    if (PySequence_Check(given.ptr()) == 0 || py::isinstance<py::str>(given))
      throw py::type_error(std::string(name) + " must be a number, or a pair of places and values");
    if (py::len(given) != 2) throw refused();
    places = numbersOf(given[py::int_(0)], name, "mm", -anything, anything);
    values = numbersOf(given[py::int_(1)], name, unit, -anything, anything);
  }
  if (values.values.empty() || values.values.size() != places.values.size() ||
      places.shape.size() > 1 || values.shape.size() > 1)
    throw refused();
  for (std::size_t i = 0; i < values.values.size(); ++i) {
    found.fromTip.push_back(millimeters(places.values[i]));
    found.value.push_back(quantity(values.values[i]));
  }
  return found;
}

/// The places of both, in order.
std::vector<Length> placesOf(const std::vector<Length>& a, const std::vector<Length>& b)
{
  std::set<Length> all(a.begin(), a.end());
  all.insert(b.begin(), b.end());
  return {all.begin(), all.end()};
}

template <class Value>
electrode::AlongArray<Value> sampledAt(const electrode::AlongArray<Value>& given,
                                       const std::vector<Length>& places)
{
  if (given.fromTip == places) return given;
  electrode::AlongArray<Value> found{places, {}};
  for (const Length place : places) found.value.push_back(given.at(place));
  return found;
}

/// The same, times the ratio of two others.
template <class Value>
electrode::AlongArray<Value> scaledAt(const electrode::AlongArray<Value>& given,
                                      const electrode::AlongArray<Value>& now,
                                      const electrode::AlongArray<Value>& before)
{
  electrode::AlongArray<Value> found{now.fromTip, {}};
  for (std::size_t i = 0; i < now.fromTip.size(); ++i) {
    const Length place = now.fromTip[i];
    found.value.push_back((given.at(place) / before.at(place)) * now.value[i]);
  }
  return found;
}

/// Two quantities of one table of the file have the same places.
template <class Value>
void alignPlaces(electrode::AlongArray<Value>& first, electrode::AlongArray<Value>& second)
{
  const std::vector<Length> places = placesOf(first.fromTip, second.fromTip);
  first = sampledAt(first, places);
  second = sampledAt(second, places);
}

std::vector<Length> lengthsOf(const py::object& given, const char* name)
{
  constexpr double longest_mm = 1000.0;
  std::vector<Length> found;
  for (const double each : numbersOf(given, name, "mm", 0.0, longest_mm).values)
    found.push_back(millimeters(each));
  return found;
}

NamedArray replaced(const NamedArray& one, const py::object& name, const py::object& maker,
                    const py::object& note, const std::optional<double>& length_mm,
                    const std::optional<double>& insertable_mm, const py::object& width_mm,
                    const py::object& thickness_mm, const std::optional<double>& tip_radius_mm,
                    const py::object& bending, const py::object& across, const py::object& torsion,
                    const py::object& curvature, const py::object& contacts,
                    const std::optional<double>& contact_length_mm, const py::object& ribs,
                    const std::vector<std::string>& without, const std::string& source)
{
  ArrayDesign array = one.design;
  std::set<std::string> changed;
  const auto text = [](const py::object& given, const char* key, std::string& value) {
    if (given.is_none()) return;
    if (!py::isinstance<py::str>(given)) throw py::type_error(std::string(key) + " must be text");
    value = given.cast<std::string>();
  };
  text(name, "name", array.name);
  text(maker, "maker", array.maker);
  text(note, "note", array.note);
  const auto length = [&](const std::optional<double>& given, const char* table, Length& value) {
    if (!given) return;
    value = millimeters(*given);
    changed.insert(table);
  };
  length(length_mm, "length", array.length);
  length(insertable_mm, "insertable", array.insertable);
  length(contact_length_mm, "contacts", array.contactLength);
  length(tip_radius_mm, "tip", array.tip.radius);
  if (!width_mm.is_none()) {
    const auto now = alongOf<Length>(width_mm, "width_mm", "mm", millimeters);
    array.thickness = scaledAt(array.thickness, now, array.diameter);
    array.diameter = now;
    changed.insert("diameter");
  }
  if (!thickness_mm.is_none()) {
    array.thickness = alongOf<Length>(thickness_mm, "thickness_mm", "mm", millimeters);
    alignPlaces(array.diameter, array.thickness);
    changed.insert("diameter");
  }
  const auto stiffness = [&](const py::object& given, const char* key) {
    changed.insert("bending");
    return alongOf<BendingStiffness>(given, key, "N m^2", newtonSquareMeters);
  };
  if (!bending.is_none()) {
    const auto now = stiffness(bending, "bending_stiffness_Nm2");
    array.bendingAcross = scaledAt(array.bendingAcross, now, array.bending);
    if (array.twisting) array.twisting = scaledAt(*array.twisting, now, array.bending);
    array.bending = now;
  }
  if (!across.is_none()) array.bendingAcross = stiffness(across, "bending_stiffness_across_Nm2");
  if (!torsion.is_none()) array.twisting = stiffness(torsion, "torsional_stiffness_Nm2");
  if (changed.count("bending") > 0) {
    alignPlaces(array.bending, array.bendingAcross);
    if (array.twisting) alignPlaces(array.bending, *array.twisting);
    alignPlaces(array.bending, array.bendingAcross);
  }
  if (!curvature.is_none()) {
    array.restCurvature =
        alongOf<Curvature>(curvature, "rest_curvature_per_mm", "1/mm", perMillimeter);
    changed.insert("rest_curvature");
  }
  if (!contacts.is_none()) {
    array.contactsFromTip = lengthsOf(contacts, "contacts_from_tip_mm");
    array.singlePlates =
        std::min(array.singlePlates, static_cast<int>(array.contactsFromTip.size()));
    changed.insert("contacts");
  }
  if (!ribs.is_none()) {
    array.ribsFromTip = lengthsOf(ribs, "ribs_from_tip_mm");
    changed.insert("ribs");
  }
  if (changed.count("diameter") + changed.count("bending") > 0) array.taper.reset();
  // what is given stands: the stiffness follows the stated wires no more
  if (changed.count("diameter") + changed.count("bending") > 0 || !contacts.is_none())
    array.wires.reset();
  for (const std::string& each : without) {
    if (each == "ribs")
      array.ribsFromTip.clear();
    else if (each == "stylet")
      array.hasStylet = false;
    else if (each == "taper")
      array.taper.reset();
    else if (each == "tip")
      array.tip = {};
    else if (each == "wires")
      array.wires.reset();
    else
      throw EngineError("without has '" + each +
                        "'; allowed are 'ribs', 'stylet', 'taper', 'tip' and 'wires'. Correct it.");
  }
  for (const std::string& table : changed) {
    const electrode::TableSource now{source, electrode::Confidence::low};
    const auto stated = std::find_if(array.provenance.begin(), array.provenance.end(),
                                     [&](const auto& each) { return each.first == table; });
    if (stated != array.provenance.end())
      stated->second = now;
    else
      array.provenance.emplace_back(table, now);
  }
  return {valueOf(electrode::parseArray(electrode::arrayText(array), "The changed array")), {}};
}

}  // namespace

std::string arrayNameOf(const py::object& given, const char* name)
{
  if (!py::isinstance<NamedArray>(given)) return nameOrFileOf(given, name);
  if (const std::string file = arrayFileOf(given); !file.empty()) return file;
  const auto& design = given.cast<const NamedArray&>().design;
  return keptFile("arrays", design.name, electrode::arrayText(design));
}

std::string arrayFileOf(const py::object& given)
{
  const auto& array = given.cast<const NamedArray&>();
  if (array.file.empty()) return {};
  const auto now = withoutLock([&] { return loadNamed(array.file); });
  return now && electrode::arrayText(*now) == electrode::arrayText(array.design) ? array.file
                                                                                 : std::string();
}

void defineArrays(py::module_& module)
{
  py::class_<NamedArray> kind(
      module, "Array",
      "An electrode array as its file describes it. Places are distances from the tip [mm]; values "
      "between the file's are linear. Not device labeling.");
  kind.def_property_readonly(
          "name", [](const NamedArray& one) { return textOf(one.design.name); }, "\"FLEX28\".")
      .def_property_readonly(
          "maker", [](const NamedArray& one) { return textOf(one.design.maker); },
          "The maker's name.")
      .def_property_readonly(
          "note", [](const NamedArray& one) { return textOf(one.design.note); },
          "Where the values come from, for the user.")
      .def_property_readonly(
          "length_mm",
          [](const NamedArray& one) { return perilymph::inMillimeters(one.design.length); },
          "From the tip to the grip of the tweezers [mm].")
      .def_property_readonly(
          "insertable_mm",
          [](const NamedArray& one) { return perilymph::inMillimeters(one.design.insertable); },
          "Maximum depth past the opening [mm].")
      .def_property_readonly(
          "contacts_from_tip_mm",
          [](const NamedArray& one) { return inMillimeters(one.design.contactsFromTip); },
          "Centers of the contacts from the tip, shape (n,) [mm].")
      .def_property_readonly(
          "contact_length_mm",
          [](const NamedArray& one) { return perilymph::inMillimeters(one.design.contactLength); },
          "Length of one contact along the array [mm].")
      .def_property_readonly(
          "ribs_from_tip_mm",
          [](const NamedArray& one) { return inMillimeters(one.design.ribsFromTip); },
          "Centers of the marker ribs from the tip, shape (n,) [mm].")
      .def_property_readonly(
          "has_stylet", [](const NamedArray& one) { return one.design.hasStylet; },
          "Whether it has a stylet or sheath.")
      .def_property_readonly("sources", &sources,
                             "(table of the file, source, confidence 'high', 'medium' or 'low').")
      .def(
          "width_mm",
          [](const NamedArray& one, const py::object& from_tip_mm) {
            return along(one.design, from_tip_mm, [&](Length place) {
              return perilymph::inMillimeters(one.design.sectionAt(place).across);
            });
          },
          py::arg("from_tip_mm"),
          "Diameter across the plane of curl at places (...) [mm], with the taper of the tip and "
          "without ribs.")
      .def(
          "thickness_mm",
          [](const NamedArray& one, const py::object& from_tip_mm) {
            return along(one.design, from_tip_mm, [&](Length place) {
              return perilymph::inMillimeters(one.design.sectionAt(place).within);
            });
          },
          py::arg("from_tip_mm"), "Diameter within the plane of curl at places (...) [mm].")
      .def(
          "bending_stiffness_Nm2",
          [](const NamedArray& one, const py::object& from_tip_mm) {
            return along(one.design, from_tip_mm,
                         [&](Length place) { return one.design.bending.at(place).si(); });
          },
          py::arg("from_tip_mm"),
          "Bending stiffness EI of the carrier within the plane of curl at places (...) [N m^2], "
          "without stylet.")
      .def(
          "bending_stiffness_across_Nm2",
          [](const NamedArray& one, const py::object& from_tip_mm) {
            return along(one.design, from_tip_mm,
                         [&](Length place) { return one.design.bendingAcrossAt(place).si(); });
          },
          py::arg("from_tip_mm"), "EI across the plane of curl at places (...) [N m^2].")
      .def(
          "torsional_stiffness_Nm2",
          [](const NamedArray& one, const py::object& from_tip_mm) {
            return along(one.design, from_tip_mm,
                         [&](Length place) { return one.design.twistingAt(place).si(); });
          },
          py::arg("from_tip_mm"), "Torsional stiffness GJ at places (...) [N m^2].")
      .def(
          "rest_curvature_per_mm",
          [](const NamedArray& one, const py::object& from_tip_mm) {
            return along(one.design, from_tip_mm, [&](Length place) {
              return inPerMillimeter(one.design.restCurvature.at(place));
            });
          },
          py::arg("from_tip_mm"),
          "Curvature of the free carrier without stylet at places (...) [1/mm]; 0: straight.")
      .def_property_readonly(
          "knots_mm", [](const NamedArray& one) { return knots(one.design); },
          "Places between which values are linear, by what they are of: 'width_mm', "
          "'bending_stiffness_Nm2', 'rest_curvature_per_mm' [mm].")
      .def("replace", &replaced, py::kw_only(), py::arg("name") = py::none(),
           py::arg("maker") = py::none(), py::arg("note") = py::none(),
           py::arg("length_mm") = py::none(), py::arg("insertable_mm") = py::none(),
           py::arg("width_mm") = py::none(), py::arg("thickness_mm") = py::none(),
           py::arg("tip_radius_mm") = py::none(), py::arg("bending_stiffness_Nm2") = py::none(),
           py::arg("bending_stiffness_across_Nm2") = py::none(),
           py::arg("torsional_stiffness_Nm2") = py::none(),
           py::arg("rest_curvature_per_mm") = py::none(),
           py::arg("contacts_from_tip_mm") = py::none(), py::arg("contact_length_mm") = py::none(),
           py::arg("ribs_from_tip_mm") = py::none(), py::arg("without") = py::tuple(),
           py::arg("source") = "changed in Python",
           "The array with other values, checked as a file is.\n\nWhat changes along the array is "
           "a number, or a pair of places from the tip [mm] and values there, linear between them. "
           "Another width gives the thickness the same ratio to it, another bending stiffness the "
           "stiffnesses across the plane of curl and in torsion, unless they are given; a width "
           "does not change a stiffness. A changed width or stiffness drops the range of its "
           "taper, and these or other contacts its wires: the array runs as it states then, "
           "whatever "
           "wire_packing and taper_fraction a scenario has. To change an array as a scenario runs "
           "it, "
           "begin with read_scenario(...).array.\nwithout: tables to leave out: 'ribs', 'stylet', "
           "'taper', 'tip', 'wires'.\n"
           "source: stated for what is changed, with low confidence.")
      .def_property_readonly(
          "text", [](const NamedArray& one) { return textOf(electrode::arrayText(one.design)); },
          "The array's file (TOML), as the programs read it, to the last bit.")
      .def(py::pickle(
          [](const NamedArray& one) {
            return py::make_tuple(py::bytes(electrode::arrayText(one.design)), py::bytes(one.file));
          },
          [](const py::tuple& state) {
            const auto text = state[0].cast<std::string>();
            return NamedArray{valueOf(electrode::parseArray(text, "a pickled array")),
                              state[1].cast<std::string>()};
          }))
      .def("__repr__",
           [](const NamedArray& one) {
             return textOf("<perilymph.Array '" + one.design.name +
                           "': " + figures::fixed(perilymph::inMillimeters(one.design.length), 1) +
                           " mm, " + std::to_string(one.design.contactsFromTip.size()) +
                           " contacts, " + widths(one.design) +
                           (one.design.hasStylet ? ", stylet>" : ">"));
           })
      .def(
          "_repr_html_",
          [](const NamedArray& one) {
            const ArrayDesign& design = one.design;
            return htmlTable(
                design.name,
                {{"maker", design.maker},
                 {"length", figures::fixed(perilymph::inMillimeters(design.length), 2) + " mm"},
                 {"insertable",
                  figures::fixed(perilymph::inMillimeters(design.insertable), 2) + " mm"},
                 {"contacts", std::to_string(design.contactsFromTip.size())},
                 {"width", widths(design)},
                 {"stylet", design.hasStylet ? "yes" : "no"},
                 {"note", design.note}});
          },
          "A table of its values for notebooks.");

  defineIdentity(kind, [](const NamedArray& one) { return electrode::arrayText(one.design); });

  module.def(
      "arrays", [] { return shippedNames("plugins/electrodes"); },
      "Names of the shipped electrode arrays.");
  module.def("read_array", &readArray, py::arg("name_or_file"),
             "Reads an electrode array: a shipped name, or a TOML file.");
}

}  // namespace perilymph::python
