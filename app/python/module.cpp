// SPDX-License-Identifier: BSD-3-Clause

// The extension module of the Python package perilymph; perilymph/__init__.py is its face.

#include "Bindings.h"
#include "perilymph/foundation/Version.h"

PYBIND11_MODULE(_engine, module)
{
  using namespace perilymph;
  // Classes and functions say that they are perilymph's.
  const pybind11::object name = module.attr("__name__");
  module.attr("__name__") = "perilymph";
  module.attr("__version__") = version();
  module.attr("build_id") = buildId();
  python::defineErrors(module);
  python::definePatient(module);
  python::defineArrays(module);
  python::defineScenario(module);
  python::defineCochlea(module);
  python::defineSimulation(module);
  python::defineInsertion(module);
  python::defineRecording(module);
  python::definePlan(module);
  python::defineStudy(module);
  python::giveSignatures(module);
  module.attr("__name__") = name;
}
