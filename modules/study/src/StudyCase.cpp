// SPDX-License-Identifier: BSD-3-Clause

// The cases of a study: from a number to the parameters of an insertion.

#include "AnyStopTravel.h"
#include "LatinHypercube.h"
#include "perilymph/session/Csv.h"
#include "perilymph/study/Study.h"

namespace perilymph::study {

StudyCase Study::caseAt(std::size_t number) const
{
  StudyCase one;
  one.number = number;
  one.cochlea = number / casesPerCochlea();
  const std::size_t within = number % casesPerCochlea();
  one.overrides = combinations_[within / samples_];
  const std::size_t sample = one.cochlea * samples_ + within % samples_;
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    one.overrides.emplace_back(
        ranges_[i].key,
        session::shortestDecimal(sampleIn(ranges_[i].low, ranges_[i].high, strata_[i][sample],
                                          strata_[i].size(), seed_, i, sample)));
  return one;
}

Result<session::InsertionParameters> Study::parametersOf(const StudyCase& one) const
{
  const StudyCochlea& cochlea = cochleae_[one.cochlea];
  session::Scenario scenario = scenarios_[one.number % casesPerCochlea() / samples_];
  if (!ranges_.empty() || !cochlea.patient.empty()) {
    session::Overrides overrides;
    for (const StudyRange& range : ranges_)
      for (const auto& [key, value] : one.overrides)
        if (key == range.key) overrides.emplace_back(key, value);
    if (!cochlea.patient.empty()) overrides.emplace_back("patient", cochlea.patient);
    if (isFullDepth_) overrides.emplace_back("stop_travel_mm", anyStopTravel);
    auto changed = scenario.with(overrides);
    if (!changed) return changed.error();
    scenario = *changed;
  }

  session::InsertionParameters parameters = scenario.parameters();
  parameters.withdraws = false;
  if (cochlea.patient.empty()) parameters.cochlea.patient = {};
  if (cochlea.draw > 0) {
    const auto patient = anatomy::samplePatient(seed_, cochlea.draw);
    if (!patient) return patient.error();
    parameters.cochlea.patient = *patient;
  }
  if (isFullDepth_) {
    const Length travel = session::fullTravel(parameters.array, parameters.startInside);
    if (!(travel.si() > 0.0))
      return Error{"The array " + parameters.array.name + " is " +
                   session::shortestDecimal(inMillimeters(parameters.array.insertable)) +
                   " mm long and would start " +
                   session::shortestDecimal(inMillimeters(parameters.startInside)) +
                   " mm inside. Lower start_inside_mm."};
    parameters.stopTravel = travel;
    parameters.engine.stopTravel = parameters.stopTravel.si();
  }
  return parameters;
}

}  // namespace perilymph::study
