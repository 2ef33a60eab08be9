// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "Bindings.h"
#include "ObjectText.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::python {

namespace {

using anatomy::Patient;
using OptionalNumber = std::optional<double>;

anatomy::Side sideOf(const std::string& name)
{
  const auto side = valueIn(anatomy::sides, name);
  if (!side) throw EngineError("side is '" + name + "'; allowed are 'right' and 'left'.");
  return *side;
}

std::optional<anatomy::BasalTurnErrors> errorsOf(const OptionalNumber& a, const OptionalNumber& b,
                                                 const OptionalNumber& h, bool hasH)
{
  if (!a && !b && !h) return std::nullopt;
  if (!a || !b || (h && !hasH))
    throw EngineError(
        "a_sd_mm and b_sd_mm belong together, and h_sd_mm to h_mm. Give all of them or none.");
  anatomy::BasalTurnErrors errors{millimeters(*a), millimeters(*b)};
  if (h) errors.h = millimeters(*h);
  return errors;
}

Patient patientOfDiameters(double a_mm, double b_mm, OptionalNumber h_mm, OptionalNumber a_sd_mm,
                           OptionalNumber b_sd_mm, OptionalNumber h_sd_mm, const std::string& side,
                           const std::string& label)
{
  Patient patient;
  patient.label = label;
  patient.side = sideOf(side);
  patient.basalTurn = {millimeters(a_mm), millimeters(b_mm), std::nullopt};
  if (h_mm) patient.basalTurn->h = millimeters(*h_mm);
  patient.errors = errorsOf(a_sd_mm, b_sd_mm, h_sd_mm, h_mm.has_value());
  valueOf(anatomy::checkPatient(patient));
  return patient;
}

Patient patientOfLengths(double length_mm, double width_mm, double height_mm,
                         const std::string& side, const std::string& label)
{
  Patient patient;
  patient.label = label;
  patient.side = sideOf(side);
  patient.scalaTympaniLength = millimeters(length_mm);
  patient.roundWindowWidth = millimeters(width_mm);
  patient.roundWindowHeight = millimeters(height_mm);
  valueOf(anatomy::checkPatient(patient));
  return patient;
}

/// Everything of a patient, lengths in meters, so that a copy has the same bits.
py::tuple stateOf(const Patient& one)
{
  const auto length = [](const std::optional<Length>& given) -> py::object {
    if (!given) return py::none();
    return py::float_(given->si());
  };
  py::object turn = py::none(), errors = py::none();
  if (one.basalTurn)
    turn = py::make_tuple(one.basalTurn->a.si(), one.basalTurn->b.si(), length(one.basalTurn->h));
  if (one.errors)
    errors = py::make_tuple(one.errors->a.si(), one.errors->b.si(), length(one.errors->h),
                            one.errors->ab, one.errors->ah, one.errors->bh);
  return py::make_tuple(
      py::bytes(one.label), one.side == anatomy::Side::left, one.scalaTympaniLength.si(),
      one.roundWindowWidth.si(), one.roundWindowHeight.si(), turn, errors,
      py::make_tuple(py::bytes(one.origin.software), py::bytes(one.origin.seriesKey),
                     py::bytes(one.origin.landmarksByHand),
                     py::bytes(one.origin.landmarksProposed)),
      std::string(nameOf(one.seal)));
}

Patient patientFrom(const py::tuple& state)
{
  if (state.size() != 9)
    throw EngineError("The pickled patient is of another version. Make it again.");
  const auto length = [](const py::handle& given) { return Length::fromSi(given.cast<double>()); };
  Patient one;
  one.label = state[0].cast<std::string>();
  one.side = state[1].cast<bool>() ? anatomy::Side::left : anatomy::Side::right;
  one.scalaTympaniLength = length(state[2]);
  one.roundWindowWidth = length(state[3]);
  one.roundWindowHeight = length(state[4]);
  if (!state[5].is_none()) {
    const auto turn = state[5].cast<py::tuple>();
    one.basalTurn = anatomy::BasalTurn{length(turn[0]), length(turn[1]), std::nullopt};
    if (!turn[2].is_none()) one.basalTurn->h = length(turn[2]);
  }
  if (!state[6].is_none()) {
    const auto errors = state[6].cast<py::tuple>();
    one.errors = anatomy::BasalTurnErrors{length(errors[0]), length(errors[1])};
    if (!errors[2].is_none()) one.errors->h = length(errors[2]);
    one.errors->ab = errors[3].cast<double>();
    one.errors->ah = errors[4].cast<double>();
    one.errors->bh = errors[5].cast<double>();
  }
  const auto origin = state[7].cast<py::tuple>();
  one.origin = {origin[0].cast<std::string>(), origin[1].cast<std::string>(),
                origin[2].cast<std::string>(), origin[3].cast<std::string>()};
  one.seal = valueIn(seals, state[8].cast<std::string>()).value_or(Seal::changed);
  valueOf(anatomy::checkPatient(one));
  return one;
}

/// Names and values of the measures: "A", "9.20 mm".
std::vector<std::pair<std::string, std::string>> rowsOf(const Patient& one)
{
  const auto mm = [](Length length, const std::optional<Length>& error) {
    return figures::fixed(inMillimeters(length), 2) + " mm" +
           (error ? " (SD " + figures::fixed(inMillimeters(*error), 2) + ")" : std::string());
  };
  std::vector<std::pair<std::string, std::string>> rows;
  if (!one.basalTurn) {
    rows = {{"scala tympani", mm(one.scalaTympaniLength, {})},
            {"round window width", mm(one.roundWindowWidth, {})},
            {"height", mm(one.roundWindowHeight, {})}};
  } else {
    const auto error = [&](Length anatomy::BasalTurnErrors::*member) {
      return one.errors ? std::optional((*one.errors).*member) : std::nullopt;
    };
    rows = {{"A", mm(one.basalTurn->a, error(&anatomy::BasalTurnErrors::a))},
            {"B", mm(one.basalTurn->b, error(&anatomy::BasalTurnErrors::b))}};
    if (one.basalTurn->h)
      rows.emplace_back("H", mm(*one.basalTurn->h, one.errors ? one.errors->h : std::nullopt));
  }
  rows.emplace_back("side", nameOf(one.side));
  return rows;
}

Patient readPatient(const py::object& given)
{
  const std::string name = nameOrFileOf(given, "patient");
  return valueOf(withoutLock([&]() -> Result<Patient> {
    const auto file = findByName("patient", "resources/patients", name);
    if (!file) return file.error();
    return anatomy::loadPatient(*file);
  }));
}

/// One of A, B and H, or of their errors.
template <class Table>
OptionalNumber lengthIn(const std::optional<Table>& table, Length Table::*member)
{
  if (!table) return std::nullopt;
  return inMillimeters((*table).*member);
}
template <class Table>
OptionalNumber lengthIn(const std::optional<Table>& table, std::optional<Length> Table::*member)
{
  if (!table || !((*table).*member)) return std::nullopt;
  return inMillimeters(*((*table).*member));
}

}  // namespace

Patient patientOf(const py::object& given)
{
  if (py::isinstance<Patient>(given)) return given.cast<Patient>();
  if (!py::isinstance<BuiltCochlea>(given)) return readPatient(given);
  return given.cast<const BuiltCochlea&>().cochlea.patient;
}

void definePatient(py::module_& module)
{
  using anatomy::BasalTurn;
  using anatomy::BasalTurnErrors;
  py::class_<Patient> kind(
      module, "Patient",
      "A patient's cochlea as measured: diameters A and B and height H of the basal turn [mm], "
      "with "
      "the standard deviations of their errors; or three lengths of the scala tympani.");
  kind.def(
          py::init(&patientOfDiameters), py::kw_only(), py::arg("a_mm"), py::arg("b_mm"),
          py::arg("h_mm") = py::none(), py::arg("a_sd_mm") = py::none(),
          py::arg("b_sd_mm") = py::none(), py::arg("h_sd_mm") = py::none(),
          py::arg("side") = "right", py::arg("label") = "patient",
          "Diameters A and B [mm], height H [mm] if measured, and the standard deviations of their "
          "errors [mm] if known. Refuses values out of the population's range.")
      .def_static("from_lengths", &patientOfLengths, py::kw_only(), py::arg("st_length_mm"),
                  py::arg("rw_width_mm"), py::arg("rw_height_mm"), py::arg("side") = "right",
                  py::arg("label") = "patient",
                  "The published anatomy: length of the scala tympani along the organ of Corti, "
                  "width and height of its section at the round window [mm].")
      .def_property_readonly(
          "label", [](const Patient& one) { return textOf(one.label); }, "Name for display.")
      .def_property_readonly(
          "side", [](const Patient& one) { return anatomy::nameOf(one.side); },
          "'right' or 'left'.")
      .def_property_readonly(
          "a_mm", [](const Patient& one) { return lengthIn(one.basalTurn, &BasalTurn::a); },
          "Diameter A of the basal turn [mm], or None.")
      .def_property_readonly(
          "b_mm", [](const Patient& one) { return lengthIn(one.basalTurn, &BasalTurn::b); },
          "Diameter B of the basal turn [mm], or None.")
      .def_property_readonly(
          "h_mm", [](const Patient& one) { return lengthIn(one.basalTurn, &BasalTurn::h); },
          "Height H of the cochlea [mm], or None.")
      .def_property_readonly(
          "a_sd_mm", [](const Patient& one) { return lengthIn(one.errors, &BasalTurnErrors::a); },
          "Standard deviation of the error of A [mm], or None.")
      .def_property_readonly(
          "b_sd_mm", [](const Patient& one) { return lengthIn(one.errors, &BasalTurnErrors::b); },
          "Standard deviation of the error of B [mm], or None.")
      .def_property_readonly(
          "h_sd_mm", [](const Patient& one) { return lengthIn(one.errors, &BasalTurnErrors::h); },
          "Standard deviation of the error of H [mm], or None.")
      .def_property_readonly(
          "seal", [](const Patient& one) { return nameOf(one.seal); },
          "'intact', 'absent' (a file without a seal) or 'changed' (by hand, after the program "
          "wrote it).")
      .def(
          "unusual",
          [](const Patient& one) {
            const auto unusual = anatomy::unusualMeasures(one);
            return std::vector<std::string>(unusual.begin(), unusual.end());
          },
          "A sentence for each measure that is rare in the population, or does not match another.")
      .def_property_readonly(
          "text", [](const Patient& one) { return textOf(anatomy::patientText(one)); },
          "The patient's file (TOML), as the programs read it.")
      .def(py::pickle(&stateOf, &patientFrom))
      .def("__repr__",
           [](const Patient& one) {
             std::string values;
             for (const auto& [name, value] : rowsOf(one)) values += ", " + name + " " + value;
             return textOf("<perilymph.Patient '" + one.label + "'" + values + ">");
           })
      .def(
          "_repr_html_", [](const Patient& one) { return htmlTable(one.label, rowsOf(one)); },
          "A table of its values for notebooks.");
  defineIdentity(kind, [](const Patient& one) { return std::string(py::repr(stateOf(one))); });

  module.def(
      "patients", [] { return shippedNames("resources/patients"); },
      "Names of the shipped patients.");
  module.def("read_patient", &readPatient, py::arg("name_or_file"),
             "Reads a patient: a shipped name, or a TOML file such as 'ct measure' writes.");
}

}  // namespace perilymph::python
