// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include "Bindings.h"
#include "NumberArrays.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Csv.h"

namespace perilymph::python {

namespace {

using session::Overrides;
using session::Scenario;

/// A value as it would follow `--set key=` on the command line.
std::string overrideText(const std::string& key, const py::handle& value)
{
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (PyIndex_Check(value.ptr()) != 0) return std::string(py::str(value));
  if (py::isinstance<py::float_>(value)) return session::shortestDecimal(value.cast<double>());
  if (py::hasattr(value, "__fspath__"))
    return nameOrFileOf(py::reinterpret_borrow<py::object>(value), key.c_str());
  throw py::type_error("the value of '" + key +
                       "' must be a number, text, True or False, or a path");
}

Overrides overridesOf(const py::object& given)
{
  Overrides overrides;
  if (given.is_none()) return overrides;
  if (!py::isinstance<py::dict>(given))
    throw py::type_error("overrides must be a dict from keys of the scenario to values");
  for (const auto& [key, value] : given.cast<py::dict>()) {
    if (!py::isinstance<py::str>(key)) throw py::type_error("keys of overrides must be text");
    const auto name = key.cast<std::string>();
    overrides.emplace_back(name, overrideText(name, value));
  }
  return overrides;
}

py::dict valuesOf(const Scenario& scenario)
{
  py::dict values;
  for (const auto& [key, value] : scenario.values()) values[textOf(key)] = fromJson(value);
  return values;
}

std::vector<std::string> keysOf(const Scenario& scenario)
{
  std::vector<std::string> keys;
  for (const auto& [key, value] : scenario.values()) keys.push_back(key);
  return keys;
}

py::list textsOf(const std::vector<std::string>& texts)
{
  py::list list;
  for (const std::string& each : texts) list.append(textOf(each));
  return list;
}

py::list filesOf(const Scenario& scenario)
{
  py::list list;
  for (const std::filesystem::path& each : scenario.files()) list.append(textOf(each.string()));
  return list;
}

}  // namespace

std::string nameOrFileOf(const py::object& given, const char* name)
{
  PyObject* path = PyOS_FSPath(given.ptr());
  if (path == nullptr) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " must be a name or a path");
  }
  const auto text = py::reinterpret_steal<py::object>(path);
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(text.ptr(), &bytes) == 0) {
    PyErr_Clear();
    throw EngineError(std::string(name) + " holds a character that no path has. Remove it.");
  }
  return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

py::object fromJson(const std::string& text)
{
  return py::module_::import("json").attr("loads")(textOf(text));
}

Scenario scenarioOf(const py::object& given, const py::object& overrides)
{
  const Overrides values = overridesOf(overrides);
  if (py::isinstance<Scenario>(given)) {
    const Scenario& scenario = given.cast<const Scenario&>();
    if (values.empty()) return scenario;
    return valueOf(withoutLock([&] { return scenario.with(values); }));
  }
  const std::string name = nameOrFileOf(given, "scenario");
  return valueOf(withoutLock([&] { return session::loadScenario(name, values); }));
}

void defineScenario(py::module_& module)
{
  py::class_<Scenario>(module, "Scenario",
                       "What an insertion is made of: cochlea, array, motion, friction, wall. "
                       "Immutable; keys have the names of the scenario's file, with units.")
      .def_property_readonly(
          "name", [](const Scenario& one) { return textOf(one.name()); }, "Name of its file.")
      .def_property_readonly(
          "title", [](const Scenario& one) { return textOf(one.title()); }, "One line for display.")
      .def_property_readonly(
          "text", [](const Scenario& one) { return textOf(one.text()); },
          "The scenario as run (TOML): read again anywhere, it gives the same insertion, bit for "
          "bit.")
      .def_property_readonly(
          "notes", [](const Scenario& one) { return textsOf(one.notes()); },
          "Sentences for the user.")
      .def_property_readonly("files", &filesOf, "All files it was read from.")
      .def_property_readonly(
          "array", [](const Scenario& one) { return one.array(); },
          "The electrode array as run: calibrated, if the scenario names a calibration.")
      .def_property_readonly(
          "patient", [](const Scenario& one) { return one.patient(); }, "The patient.")
      .def("keys", &keysOf, "All keys, in order.")
      .def("values", &valuesOf,
           "Every key as run with its value; the patient's are 'patient_numbers.a_mm' and so on.")
      .def(
          "__getitem__",
          [](const Scenario& one, const std::string& key) -> py::object {
            for (const auto& [name, value] : one.values())
              if (name == key) return fromJson(value);
            throw py::key_error(key);
          },
          py::arg("key"))
      .def(
          "with_values",
          [](const Scenario& one, const py::object& overrides) {
            const Overrides values = overridesOf(overrides);
            return valueOf(withoutLock([&] { return one.with(values); }));
          },
          py::arg("overrides"),
          "The scenario with other values, by key, as with '--set key=value'.")
      .def("__repr__",
           [](const Scenario& one) { return textOf("<perilymph.Scenario '" + one.name() + "'>"); });

  module.def(
      "scenarios", [] { return shippedNames("resources/scenarios"); },
      "Names of the shipped scenarios.");
  module.def(
      "read_scenario", &scenarioOf, py::arg("name_or_file"), py::arg("overrides") = py::none(),
      "Reads a scenario: a shipped name or a TOML file; with values that replace its own, by "
      "key, as with '--set key=value'.");
}

}  // namespace perilymph::python
