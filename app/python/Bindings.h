// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the module offers, by subject. Lengths in mm, angles in degrees, forces in N or mN, as each
// name says.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "PythonErrors.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::python {

/// Measures of a cochlea, once they are asked for.
struct KeptMeasures {
  std::vector<analysis::Measure> measures;
  std::optional<std::vector<double>> errors;
};

/// A cochlea and its scala tympani, built.
struct BuiltCochlea {
  anatomy::Cochlea cochlea;
  std::shared_ptr<const anatomy::ScalaTympani> scala;
  bool isOfScenario = false;  ///< Its lead-in is a scenario's, which an insertion into it has too.
  std::shared_ptr<KeptMeasures> kept = std::make_shared<KeptMeasures>();
};

/// An electrode array, and where it was read from.
struct NamedArray {
  electrode::ArrayDesign design;
  std::string file;  ///< Name or path as given; empty of an array that was changed since.
};

void definePatient(py::module_& module);
void defineCochlea(py::module_& module);
void defineArrays(py::module_& module);
void defineScenario(py::module_& module);
void defineSimulation(py::module_& module);
void defineInsertion(py::module_& module);
void definePlan(py::module_& module);
void defineStudy(py::module_& module);
void defineRecording(py::module_& module);

/// A scenario as given: a Scenario, or the name or path of one; with other values.
session::Scenario scenarioOf(const py::object& given, const py::object& overrides);

/// Name or path as text: str or os.PathLike. @throws py::type_error for anything else.
std::string nameOrFileOf(const py::object& given, const char* name);

/// Name or path of an array that is given as such or as an Array. An Array that is not from a file is
/// kept as one, see keptFile().
std::string arrayNameOf(const py::object& given, const char* name);
/// Name or path of the file that an Array was read from, as long as it has its content; else empty.
std::string arrayFileOf(const py::object& given);

/// Name or path of a friction that is given as such or as a Friction, which is kept as a file.
std::string frictionNameOf(const py::object& given);

/// Name or path of a scenario that is given as such or as a Scenario, which is kept as a file.
std::string scenarioNameOf(const py::object& given);

/// A file of the user's data folder with this text, written if it is not there: what is built in
/// Python has a place, by its content, that scenarios, plans and recordings can name.
///
/// @param kind  Name of the folder: "arrays".
/// @param name  Beginning of the file's name, of which letters and digits remain.
std::string keptFile(const char* kind, const std::string& name, const std::string& text);

/// A patient for plans and studies: a Patient, the one of a Cochlea, or the name or file of one.
anatomy::Patient patientOf(const py::object& given);

/// Makes a table of columns: a pandas DataFrame.
py::object dataFrameOf(const py::dict& columns);

/// An empty dictionary in which keys that were renamed are found by their former name, too, with a
/// warning, until version 1.0.
py::dict dictOfRenamed();

/// Gives the functions and classes of a module signatures that help() and inspect show.
void giveSignatures(const py::module_& module);

/// A fingerprint as 16 hexadecimal digits.
std::string fingerprintText(std::uint64_t fingerprint);

/// What a JSON text says, as Python's json reads it.
py::object fromJson(const std::string& text);

}  // namespace perilymph::python
