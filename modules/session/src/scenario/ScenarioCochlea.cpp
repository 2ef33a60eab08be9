// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioCochlea.h"

#include "scenario/ScenarioFiles.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// The patient that an effective text carries: three lengths, or A, B and perhaps H, or a label
/// alone where an anatomy needs no numbers.
anatomy::Patient patientFromNumbers(TomlReader numbers)
{
  anatomy::Patient patient;
  patient.label = numbers.text("label", patient.label);
  if (numbers.flag("changed_by_hand", false)) patient.seal = Seal::changed;
  if (numbers.has("a_mm")) {
    // the population's limits are checked with the whole patient
    const auto diameter = [&numbers](const char* key) {
      return millimeters(numbers.number(key, {0.0, 20.0}));
    };
    anatomy::BasalTurn turn{diameter("a_mm"), diameter("b_mm"), std::nullopt};
    if (numbers.has("h_mm")) turn.h = diameter("h_mm");
    patient.basalTurn = turn;
    if (numbers.has("a_sd_mm")) {
      anatomy::BasalTurnErrors errors{diameter("a_sd_mm"), diameter("b_sd_mm")};
      if (numbers.has("h_sd_mm")) errors.h = diameter("h_sd_mm");
      patient.errors = errors;
    }
    return patient;
  }
  if (!numbers.has("st_length_mm")) return patient;
  const anatomy::PatientLimits limits = anatomy::patientLimits();
  const auto length = [&numbers](const char* key, Length low, Length high) {
    return millimeters(numbers.number(key, {inMillimeters(low), inMillimeters(high)}));
  };
  patient.scalaTympaniLength = length("st_length_mm", limits.lengthLow, limits.lengthHigh);
  patient.roundWindowWidth = length("rw_width_mm", limits.widthLow, limits.widthHigh);
  patient.roundWindowHeight = length("rw_height_mm", limits.heightLow, limits.heightHigh);
  return patient;
}

Result<anatomy::Patient> readPatient(TomlReader& reader, const std::string& name,
                                     const fs::path& folder, bool isOverridden)
{
  anatomy::Patient patient;
  const bool hasNumbers = reader.has("patient_numbers");
  if (hasNumbers) patient = patientFromNumbers(reader.table("patient_numbers"));
  if (name.empty() && isOverridden) return anatomy::Patient{};  // the scenario without its patient
  if (name.empty() || (hasNumbers && !isOverridden)) return patient;
  const auto file = findPatient(name, folder);
  if (!file) return file.error();
  return anatomy::loadPatient(*file);
}

/// The anatomy that the key names, by default the one that the patient's numbers build, and the
/// mean one without a patient.
void readAnatomy(TomlReader& reader, ScenarioKeys& keys, const anatomy::Patient& patient,
                 bool hasPatient, anatomy::AnatomySource& anatomy)
{
  using anatomy::PatientMeasures;
  const PatientMeasures given =
      hasPatient || patient.basalTurn ? measuresOf(patient) : PatientMeasures::none;
  const anatomy::AnatomySource usual =
      given == PatientMeasures::none ? anatomy::defaultAnatomy : sourceScaledBy(given);
  const std::string name = keys.text("anatomy", nameOf(usual));
  const auto named = anatomy::anatomySourceNamed(name);
  if (!named)
    return reader.refuse("anatomy", "anatomy is '" + name + "'; it must be one of " +
                                        joined(anatomy::anatomySourceNames()) + ".");
  anatomy = *named;
  const anatomy::AnatomySourceTraits& traits = traitsOf(anatomy);
  const std::string head = "anatomy is '" + name + "', ";
  if (traits.takes == PatientMeasures::none) {
    if (hasPatient)
      reader.refuse("anatomy", head +
                                   "which is not built from a patient's numbers; leave 'patient' "
                                   "out.");
    return;
  }
  if (given == PatientMeasures::none || given == traits.takes) return;
  const std::string other = nameOf(sourceScaledBy(given));
  reader.refuse("anatomy", head + "but the patient '" + patient.label + "' gives " + keysOf(given) +
                               ", from which the " + other + " anatomy is built; " +
                               (traits.alwaysTakes ? "set anatomy to '" + other + "'."
                                                   : std::string("name a patient with ") +
                                                         keysOf(traits.takes) + ", or none."));
}

}  // namespace

Result<void> readCochlea(TomlReader& reader, ScenarioKeys& keys, const std::string& patient,
                         const fs::path& folder, bool isOverridden, anatomy::Cochlea& cochlea)
{
  auto read = readPatient(reader, patient, folder, isOverridden);
  if (!read) {
    reader.text("anatomy", "");  // known, but without its patient nothing to compare with
    return read.error();
  }
  cochlea.patient = *std::move(read);
  const bool hasLengths = reader.table("patient_numbers").has("st_length_mm");
  const bool hasPatient = !patient.empty() || (hasLengths && !isOverridden);
  readAnatomy(reader, keys, cochlea.patient, hasPatient, cochlea.source);
  return {};
}

}  // namespace perilymph::session
