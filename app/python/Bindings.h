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
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::python {

/// A cochlea and its scala tympani, built.
struct BuiltCochlea {
  anatomy::Cochlea cochlea;
  std::shared_ptr<const anatomy::ScalaTympani> scala;
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

/// A fingerprint as 16 hexadecimal digits.
std::string fingerprintText(std::uint64_t fingerprint);

/// What a JSON text says, as Python's json reads it.
py::object fromJson(const std::string& text);

}  // namespace perilymph::python
