// SPDX-License-Identifier: BSD-3-Clause

// The cases of a study: from a number to the parameters of an insertion.

#include <cmath>
#include <string_view>

#include "LatinHypercube.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/InsertionParameters.h"
#include "perilymph/study/Study.h"

namespace perilymph::study {

namespace {

/// Beginning of the keys of a patient in Scenario::values().
constexpr std::string_view patientKeys = "patient_numbers.";

/// Millimeters of a length as TOML: the number that gives the same length, if there is one.
std::string decimalOf(Length length)
{
  double number = inMillimeters(length);
  for (const double each : {number, std::nextafter(number, 0.0), std::nextafter(number, HUGE_VAL)})
    if (millimeters(each) == length) {
      number = each;
      break;
    }
  const std::string text = session::shortestDecimal(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace

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

Result<session::Scenario> Study::variedScenario(const StudyCase& one) const
{
  const StudyCochlea& cochlea = cochleae_[one.cochlea];
  const session::Scenario& scenario = scenarios_[one.number % casesPerCochlea() / samples_];
  if (ranges_.empty() && cochlea.patient.empty()) return scenario;
  session::Overrides overrides;
  for (const StudyRange& range : ranges_)
    for (const auto& [key, value] : one.overrides)
      if (key == range.key) overrides.emplace_back(key, value);
  if (!cochlea.patient.empty()) overrides.emplace_back("patient", cochlea.patient);
  if (isFullDepth_) overrides.emplace_back("stop_travel_mm", session::anyStopTravel);
  return scenario.with(overrides);
}

Result<session::InsertionParameters> Study::parametersOf(const StudyCase& one) const
{
  const StudyCochlea& cochlea = cochleae_[one.cochlea];
  const auto scenario = variedScenario(one);
  if (!scenario) return scenario.error();
  session::InsertionParameters parameters = scenario->parameters();
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
      return Error{
          "The array %1 is %2 mm long and would start %3 mm inside. Lower start_inside_mm.",
          parameters.array.name,
          session::shortestDecimal(inMillimeters(parameters.array.insertable)),
          session::shortestDecimal(inMillimeters(parameters.startInside))};
    parameters.stopTravel = travel;
    parameters.engine.stopTravel = parameters.stopTravel.si();
  }
  return parameters;
}

Result<session::Scenario> Study::scenarioOf(const StudyCase& one) const
{
  const auto scenario = variedScenario(one);
  if (!scenario) return scenario.error();
  const auto parameters = parametersOf(one);
  if (!parameters) return parameters.error();
  const bool hasOwnPatient = !cochleae_[one.cochlea].patient.empty();
  std::string text, numbers;
  for (const auto& [key, value] : scenario->values()) {
    const bool isOfPatient = key.starts_with(patientKeys);
    if (key == "patient" || key == "withdraw" || key == "stop_travel_mm" || key == "title" ||
        (isOfPatient && !hasOwnPatient))
      continue;
    (isOfPatient ? numbers : text) +=
        (isOfPatient ? key.substr(patientKeys.size()) : key) + " = " + value + '\n';
  }
  text += "title = \"Insertion " + std::to_string(one.number) + " of a study\"\n";
  text += "withdraw = false\nstop_travel_mm = " + decimalOf(parameters->stopTravel) + '\n';
  if (const auto& turn = parameters->cochlea.patient.basalTurn; turn && !hasOwnPatient) {
    numbers +=
        "label = \"Simulated cochlea " + std::to_string(cochleae_[one.cochlea].draw) + "\"\n";
    numbers += "a_mm = " + decimalOf(turn->a) + "\nb_mm = " + decimalOf(turn->b) + '\n';
  }
  if (!numbers.empty()) text += "\n[patient_numbers]\n" + numbers;
  return session::parseScenario(text, scenario->name() + ".toml");
}

}  // namespace perilymph::study
