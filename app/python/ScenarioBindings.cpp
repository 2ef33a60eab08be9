// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>
#include <stdlib.h>

#include <system_error>

#include "Bindings.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Csv.h"

namespace perilymph::python {

namespace {

using session::Overrides;
using session::Scenario;

/// Values that replace a scenario's, with the files they name while it is read.
class GivenValues {
public:
  explicit GivenValues(const py::object& given)
  {
    if (given.is_none()) return;
    const bool isMapping = py::hasattr(given, "keys") && py::hasattr(given, "__getitem__");
    if (!isMapping || py::isinstance<Scenario>(given))
      throw py::type_error("overrides must be a dict from keys of the scenario to values");
    try {
      const py::dict values(given);
      for (const auto& [key, value] : values) {
        if (!py::isinstance<py::str>(key)) throw py::type_error("keys of overrides must be text");
        add(key.cast<std::string>(), py::reinterpret_borrow<py::object>(value));
      }
      if (cochlea_ && values.contains("patient"))
        throw EngineError(
            "A patient and a cochlea are given; the cochlea is of a patient. Give one of them.");
      if (cochlea_ && values.contains("anatomy"))
        throw EngineError(
            "An anatomy and a cochlea are given; the cochlea is of an anatomy. Give one of them.");
      // what is said by its key counts, in whatever order
      overrides_.insert(overrides_.end(), own_.begin(), own_.end());
    } catch (...) {
      removeFiles();
      throw;
    }
  }
  ~GivenValues() { removeFiles(); }
  GivenValues(const GivenValues&) = delete;
  GivenValues& operator=(const GivenValues&) = delete;

  const Overrides& overrides() const { return overrides_; }
  /// A scenario that was read with them, in which the patient has its label in place of the file.
  Result<Scenario> named(Result<Scenario> read) const
  {
    if (!read || patientFile_.empty()) return read;
    std::string text = read->text();
    const std::size_t place = text.find(patientFile_);
    if (place == std::string::npos) return read;
    text.replace(place, patientFile_.size(), patientLabel_);
    return session::parseScenario(text, read->name() + ".toml");
  }
  /// The cochlea that was given as a Cochlea.
  const std::optional<anatomy::Cochlea>& cochlea() const { return cochlea_; }

private:
  void add(const std::string& key, const py::object& value)
  {
    if (py::isinstance<anatomy::Patient>(value)) {
      require(key, "patient", "a Patient");
      addPatient(value.cast<const anatomy::Patient&>());
    } else if (py::isinstance<BuiltCochlea>(value)) {
      require(key, "cochlea", "a Cochlea");
      addCochlea(value.cast<const BuiltCochlea&>());
    } else if (py::isinstance<NamedArray>(value)) {
      require(key, "array", "an Array");
      overrides_.emplace_back(key, arrayNameOf(value, "array"));
    } else if (py::hasattr(value, "scenario_values")) {
      require(key, "friction", "a Friction");
      for (const auto& [each, number] : value.attr("scenario_values")().cast<py::dict>()) {
        const auto name = each.cast<std::string>();
        overrides_.emplace_back(name, textFor(name, py::reinterpret_borrow<py::object>(number)));
      }
    } else {
      own_.emplace_back(key, textFor(key, value));
    }
  }

  static void require(const std::string& key, const char* expected, const char* what)
  {
    if (key != expected)
      throw py::type_error("the value of '" + key + "' is " + what + ", which belongs to '" +
                           expected + "'");
  }

  /// A value as it would follow `--set key=` on the command line.
  static std::string textFor(const std::string& key, const py::object& value)
  {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    const bool isList = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value) ||
                        (py::isinstance<py::array>(value) && value.cast<py::array>().ndim() > 0);
    if (isList) return listFor(key, value);
    if (PyIndex_Check(value.ptr()) != 0) return std::string(py::str(value));
    if (py::hasattr(value, "__fspath__")) return nameOrFileOf(value, key.c_str());
    if (py::hasattr(value, "__float__"))
      return session::shortestDecimal(py::float_(value).cast<double>());
    throw py::type_error("the value of '" + key +
                         "' must be a number, numbers, text, True or False, a path, or an object "
                         "of this package");
  }

  static std::string listFor(const std::string& key, const py::object& value)
  {
    constexpr double anything = 1e12;
    std::string list;
    for (const double each :
         numbersOf(value, key.c_str(), "(units of its name)", -anything, anything).values)
      list += (list.empty() ? "" : ", ") + session::shortestDecimal(each);
    return '[' + list + ']';
  }

  void addPatient(const anatomy::Patient& patient)
  {
    const auto folder = valueOf(temporaryFolder());
    files_.push_back(folder);
    const auto file = folder / "patient.toml";
    valueOf(withoutLock([&] { return anatomy::savePatient(patient, file); }));
    overrides_.emplace_back("patient", file.string());
    patientFile_ = file.string();
    for (const char each : patient.label)  // as text in a scenario's file
      if (each != '"' && each != '\\' && static_cast<unsigned char>(each) >= 0x20 && each != 0x7f)
        patientLabel_ += each;
  }

  void addCochlea(const BuiltCochlea& given)
  {
    const anatomy::Cochlea& cochlea = given.cochlea;
    cochlea_ = cochlea;
    if (isScaledBy(cochlea.source, cochlea.patient)) addPatient(cochlea.patient);
    overrides_.emplace_back("anatomy", nameOf(cochlea.source));
    if (given.isOfScenario)
      overrides_.emplace_back("lead_in_mm",
                              session::shortestDecimal(inMillimeters(cochlea.leadIn)));
  }

  static Result<std::filesystem::path> temporaryFolder()
  {
    std::error_code error;
    auto pattern = (std::filesystem::temp_directory_path(error) / "perilymph-XXXXXX").string();
    if (error || mkdtemp(pattern.data()) == nullptr)
      return Error{"No temporary folder can be made. Make TMPDIR a folder that is writable."};
    return std::filesystem::path(pattern);
  }

  void removeFiles() noexcept
  {
    std::error_code ignored;
    for (const std::filesystem::path& folder : files_) std::filesystem::remove_all(folder, ignored);
    files_.clear();
  }

  Overrides overrides_;  ///< What objects say, then what is said by its own key.
  Overrides own_;
  std::optional<anatomy::Cochlea> cochlea_;
  std::string patientFile_, patientLabel_;
  std::vector<std::filesystem::path> files_;  ///< Folders with names and measures of patients.
};

/// Refuses a scenario that keeps a patient where a Cochlea without one was given.
Scenario checkedCochlea(Scenario scenario, const GivenValues& given)
{
  const auto& cochlea = given.cochlea();
  if (cochlea && !isScaledBy(cochlea->source, cochlea->patient) &&
      isScaledBy(scenario.anatomy(), scenario.patient()))
    throw EngineError("The scenario '" + scenario.name() +
                      "' is of a patient, and the cochlea is of none. Give a scenario without a "
                      "patient.");
  return scenario;
}

Scenario withValues(const Scenario& scenario, const py::object& overrides)
{
  const GivenValues given(overrides);
  if (given.overrides().empty()) return scenario;
  return checkedCochlea(
      valueOf(withoutLock([&] { return given.named(scenario.with(given.overrides())); })), given);
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
  if (py::isinstance<Scenario>(given)) return withValues(given.cast<const Scenario&>(), overrides);
  const GivenValues values(overrides);
  const std::string name = nameOrFileOf(given, "scenario");
  return checkedCochlea(valueOf(withoutLock([&] {
                          return values.named(session::loadScenario(name, values.overrides()));
                        })),
                        values);
}

void defineScenario(py::module_& module)
{
  py::class_<Scenario> kind(module, "Scenario",
                            "What an insertion is made of: cochlea, array, motion, friction, wall. "
                            "Immutable; keys have the names of the scenario's file, with units.");
  kind.def_property_readonly(
          "name", [](const Scenario& one) { return textOf(one.name()); }, "Name of its file.")
      .def_property_readonly(
          "title", [](const Scenario& one) { return textOf(one.title()); }, "One line for display.")
      .def_property_readonly(
          "text", [](const Scenario& one) { return textOf(one.text()); },
          "The scenario as run (TOML): read again anywhere, it gives the same insertion, bit for "
          "bit.")
      .def_property_readonly(
          "notes",
          [](const Scenario& one) {
            std::vector<std::string> notes = one.notes();
            if (const std::string note = noteOn(one.patient()); !note.empty())
              notes.push_back(note);
            return textsOf(notes);
          },
          "Sentences for the user.")
      .def_property_readonly("files", &filesOf, "All files it was read from.")
      .def_property_readonly(
          "array",
          [](const Scenario& one) {
            return NamedArray{one.array(), {}};
          },
          "The electrode array as run: calibrated, if the scenario names a calibration.")
      .def_property_readonly(
          "patient", [](const Scenario& one) { return one.patient(); }, "The patient.")
      .def("keys", &keysOf, "All keys, in order.")
      .def(
          "values",
          [](const Scenario& one) {
            return py::module_::import("perilymph._tables").attr("Values")(valuesOf(one));
          },
          "The values as run, in the order of keys(): a list. dict(scenario) has both.")
      .def(
          "items", [](const Scenario& one) { return py::list(valuesOf(one).attr("items")()); },
          "(key, value) of each key as run; the patient's are 'patient_numbers.a_mm' and so on.")
      .def(
          "get",
          [](const Scenario& one, const py::object& key, const py::object& missing) {
            return py::object(valuesOf(one).attr("get")(key, missing));
          },
          py::arg("key"), py::arg("default") = py::none(),
          "The value of a key, or `default` where there is none.")
      .def(
          "__getitem__",
          [](const Scenario& one, const std::string& key) -> py::object {
            for (const auto& [name, value] : one.values())
              if (name == key) return fromJson(value);
            PyErr_SetObject(PyExc_KeyError, textOf(key).ptr());
            throw py::error_already_set();
          },
          py::arg("key"))
      .def("with_values", &withValues, py::arg("overrides"),
           "The scenario with other values, by key, as with '--set key=value'; lists of numbers, a "
           "Patient, an Array, a Friction, and a Cochlea as 'cochlea', too.")
      .def("__len__", [](const Scenario& one) { return one.values().size(); })
      .def("__iter__", [](const Scenario& one) { return py::iter(py::cast(keysOf(one))); })
      .def(
          "__contains__",
          [](const Scenario& one, const py::object& key) {
            return py::cast(keysOf(one)).contains(key);
          },
          py::arg("key"))
      .def(py::pickle(
          [](const Scenario& one) {
            return py::make_tuple(py::bytes(one.text()), py::bytes(one.name()));
          },
          [](const py::tuple& state) {
            const auto text = state[0].cast<std::string>(), name = state[1].cast<std::string>();
            Scenario one =
                valueOf(withoutLock([&] { return session::parseScenario(text, name + ".toml"); }));
            if (one.arrayFingerprint() != one.expectedArrayFingerprint())
              throw EngineError("The file of the array " + one.array().name +
                                " was changed since the scenario " + name +
                                " was read. Read the scenario again.");
            return one;
          }))
      .def("__repr__",
           [](const Scenario& one) {
             return textOf("<perilymph.Scenario '" + one.name() + "': array '" + one.arrayName() +
                           "', " + nameOf(one.anatomy()) + " cochlea of '" + one.patient().label +
                           "', " + session::shortestDecimal(inMillimetersPerSecond(one.speed())) +
                           " mm/s>");
           })
      .def(
          "_repr_html_",
          [](const Scenario& one) {
            std::vector<std::pair<std::string, std::string>> rows(one.values().begin(),
                                                                  one.values().end());
            return htmlTable(one.name(), rows);
          },
          "A table of its values for notebooks.");
  py::module_::import("collections.abc").attr("Mapping").attr("register")(kind);
  defineIdentity(kind, [](const Scenario& one) { return one.name() + '\n' + one.text(); });

  module.def(
      "scenarios", [] { return shippedNames("resources/scenarios"); },
      "Names of the shipped scenarios.");
  module.def(
      "frictions", [] { return shippedNames("resources/friction"); },
      "Names of the shipped frictions, for the key 'friction' of a scenario.");
  module.def(
      "read_scenario", &scenarioOf, py::arg("name_or_file"), py::arg("overrides") = py::none(),
      "Reads a scenario: a shipped name or a TOML file; with values that replace its own, by "
      "key, as with '--set key=value'.");
}

}  // namespace perilymph::python
