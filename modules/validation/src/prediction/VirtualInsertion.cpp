// SPDX-License-Identifier: BSD-3-Clause
#include "prediction/VirtualInsertion.h"

#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Csv.h"

namespace perilymph::validation {

Result<session::Scenario> fullInsertionOf(const std::string& scenario, const std::string& array,
                                          Length startInside, Duration timeStep,
                                          const session::Overrides& overrides)
{
  const auto file = findByName("array", "plugins/electrodes", array);
  if (!file) return file.error();
  const auto design = electrode::loadArray(*file);
  if (!design) return design.error();
  session::Overrides all = {
      {"array", file->string()},
      {"start_inside_mm", session::shortestDecimal(inMillimeters(startInside))},
      {"stop_travel_mm",
       session::shortestDecimal(inMillimeters(session::fullTravel(*design, startInside)))},
      {"dt_ms", session::shortestDecimal(timeStep.si() * 1e3)}};
  all.insert(all.end(), overrides.begin(), overrides.end());
  auto loaded = session::loadScenario(scenario, all);
  if (!loaded) return Error{"%1: %2", array, loaded.error().message};
  return loaded;
}

Result<session::InsertionParameters> withCochlea(const session::InsertionParameters& nominal,
                                                 std::uint64_t seed, std::uint64_t number)
{
  session::InsertionParameters parameters = nominal;
  parameters.cochlea.source = anatomy::AnatomySource::mean;
  if (number == 0) {
    parameters.cochlea.patient = {};
    return parameters;
  }
  auto patient = anatomy::samplePatient(seed, number);
  if (!patient) return patient.error();
  parameters.cochlea.patient = *patient;
  return parameters;
}

}  // namespace perilymph::validation
