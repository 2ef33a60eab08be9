// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PatientRegistry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "DictionaryCsv.h"
#include "PlanNumbers.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/RecordedResults.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/SavedPatients.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::planning {

namespace {

constexpr const char *measured = "measures that were saved; 95 % interval: 1.96 standard errors",
                     *ofPlan = "plan.json of the newest plan",
                     *ofRecording = "newest recording, as in its report",
                     *ofInserted = "plan.json of the newest plan, array of the newest insertion";

constexpr DictionaryRow registryColumns[] = {
    {"code", "", "code of the patient", "typed by the user"},
    {"ear", "", "left or right", "typed by the user or seen in the CT"},
    {"archived", "", "1: the patient is hidden in the list of patients", "record of the patient"},
    {"measured_utc", "", "when these measures were saved, ISO 8601", "record of the patient"},
    {"measures_from", "",
     "ct: measured in a CT; typed: entered by a person; changed_by_hand: the file was changed "
     "after "
     "it was written",
     "seal and origin in the patient's file"},
    {"A_mm", "mm", "diameter A of the basal turn; empty if three lengths are known instead",
     measured},
    {"A_low_mm", "mm", "95 % interval, lower end; errors that nobody stated are 0.1 mm (SD)",
     measured},
    {"A_high_mm", "mm", "upper end", measured},
    {"B_mm", "mm", "width B of the basal turn, perpendicular to A", measured},
    {"B_low_mm", "mm", "95 % interval, lower end", measured},
    {"B_high_mm", "mm", "upper end", measured},
    {"H_mm", "mm", "height of the cochlea; empty if it was not measured", measured},
    {"H_low_mm", "mm", "95 % interval, lower end", measured},
    {"H_high_mm", "mm", "upper end", measured},
    {"st_length_mm", "mm", "length of the organ of Corti; empty if A and B are known", measured},
    {"st_length_low_mm", "mm", "95 % interval, lower end", measured},
    {"st_length_high_mm", "mm", "upper end", measured},
    {"rw_width_mm", "mm", "width of the scala at the round window; empty if A and B are known",
     measured},
    {"rw_width_low_mm", "mm", "95 % interval, lower end", measured},
    {"rw_width_high_mm", "mm", "upper end", measured},
    {"rw_height_mm", "mm", "height of the scala at the round window; empty if A and B are known",
     measured},
    {"rw_height_low_mm", "mm", "95 % interval, lower end", measured},
    {"rw_height_high_mm", "mm", "upper end", measured},
    {"cdl_oc_mm", "mm", "cochlear duct length along the organ of Corti, of the built cochlea",
     "Schurzig et al. 2018, from A and B"},
    {"cdl_oc_low_mm", "mm", "95 % interval of the measures' errors and the formula, lower end",
     "Schurzig et al. 2018, from A and B"},
    {"cdl_oc_high_mm", "mm", "upper end", "Schurzig et al. 2018, from A and B"},
    {"plan_utc", "", "when the newest plan was made; empty without a plan", "the plan's folder"},
    {"plan_of_these_measures", "", "1: the plan was made with the measures of this row; 0: others",
     "measures in plan.json"},
    {"plan_bands_hold", "", "what a band from p5 to p95 holds and what it holds fixed", ofPlan},
    {"plan_arrays", "", "file names of the arrays, separated by semicolons", ofPlan},
    {"plan_simulations", "", "simulations of each array, in the order of plan_arrays", ofPlan},
    {"plan_angle_deg", "degrees",
     "angular insertion depth, of the most apical contact: medians in the order of plan_arrays",
     ofPlan},
    {"plan_angle_p5_deg", "degrees", "5 % quantile of the simulations, the lowest of fewer than 19",
     ofPlan},
    {"plan_angle_p95_deg", "degrees", "95 % quantile", ofPlan},
    {"plan_depth_mm", "mm", "insertion depth of the tip past the opening, medians", ofPlan},
    {"plan_depth_p5_mm", "mm", "5 % quantile", ofPlan},
    {"plan_depth_p95_mm", "mm", "95 % quantile", ofPlan},
    {"plan_peak_mN", "mN", "peak insertion force, medians", ofPlan},
    {"plan_peak_p5_mN", "mN", "5 % quantile", ofPlan},
    {"plan_peak_p95_mN", "mN", "95 % quantile", ofPlan},
    {"plan_end_mN", "mN", "end force, medians", ofPlan},
    {"plan_end_p5_mN", "mN", "5 % quantile", ofPlan},
    {"plan_end_p95_mN", "mN", "95 % quantile", ofPlan},
    {"insertion_utc", "", "when the newest simulated insertion began; empty without one",
     ofRecording},
    {"insertion_array", "", "file name of the array", ofRecording},
    {"insertion_depth_mm", "mm", "maximum insertion depth of the tip past the opening",
     ofRecording},
    {"insertion_angle_deg", "degrees",
     "angular insertion depth there, of the most apical contact; empty with no contact inside",
     ofRecording},
    {"insertion_contacts_inside", "", "contacts past the opening there", ofRecording},
    {"insertion_contacts", "", "contacts of the array", ofRecording},
    {"insertion_peak_mN", "mN", "peak insertion force", ofRecording},
    {"insertion_end_mN", "mN", "end force: at the stop", ofRecording},
    {"insertion_outcome", "",
     "finished, stopped_by_resistance, buckled, out_of_opening, folded_tip, jammed or fault; none: "
     "ended by hand",
     ofRecording},
    {"insertion_translocated", "", "1: a part of the array went into the scala vestibuli",
     ofRecording},
    {"insertion_verified", "",
     "1: the replay gave the same bits; 0: it did not, and depth, angle and contacts may be "
     "another "
     "version's",
     "replay of the recording"},
    {"planned_angle_deg", "degrees",
     "angular insertion depth that the plan states for the inserted array, median; empty if the "
     "plan has not this array",
     ofInserted},
    {"planned_angle_p5_deg", "degrees", "5 % quantile", ofInserted},
    {"planned_angle_p95_deg", "degrees", "95 % quantile", ofInserted},
    {"planned_depth_mm", "mm", "insertion depth, median", ofInserted},
    {"planned_depth_p5_mm", "mm", "5 % quantile", ofInserted},
    {"planned_depth_p95_mm", "mm", "95 % quantile", ofInserted},
    {"planned_peak_mN", "mN", "peak insertion force, median", ofInserted},
    {"planned_peak_p5_mN", "mN", "5 % quantile", ofInserted},
    {"planned_peak_p95_mN", "mN", "95 % quantile", ofInserted},
    {"planned_end_mN", "mN", "end force, median", ofInserted},
    {"planned_end_p5_mN", "mN", "5 % quantile", ofInserted},
    {"planned_end_p95_mN", "mN", "95 % quantile", ofInserted},
    {"planned_all_inside_percent", "%", "probability that all contacts end inside", ofInserted},
    {"planned_all_inside_low_percent", "%", "its 95 % interval, lower end", ofInserted},
    {"planned_all_inside_high_percent", "%", "upper end", ofInserted},
    {"planned_translocated_percent", "%",
     "probability that a part of the array ends in the scala vestibuli", ofInserted},
    {"planned_translocated_low_percent", "%", "its 95 % interval, lower end", ofInserted},
    {"planned_translocated_high_percent", "%", "upper end", ofInserted},
    {"outcome_utc", "", "when the newest CT after surgery was recorded; empty if none was",
     "record of the patient"}};

std::string numberText(double value) { return session::shortestDecimal(rounded(value)); }

/// The fields of a row by column; those that are not set are empty.
class RegistryRow {
public:
  void set(const std::string& column, std::string text)
  {
    const bool isKnown = std::any_of(std::begin(registryColumns), std::end(registryColumns),
                                     [&](const DictionaryRow& each) { return each.key == column; });
    if (!isKnown) throw std::logic_error("The registry has no column '" + column + "'.");
    fields_[column] = std::move(text);
  }
  void set(const std::string& column, double value)
  {
    if (std::isfinite(value)) set(column, numberText(value));
  }

  std::string csv() const
  {
    std::string row;
    for (const DictionaryRow& each : registryColumns) {
      const auto found = fields_.find(each.key);
      if (&each != registryColumns) row += ',';
      if (found != fields_.end()) row += csvField(found->second);
    }
    return row + "\n";
  }

private:
  std::map<std::string, std::string, std::less<>> fields_;
};

/// A measure with its 95 % interval, in millimeters: "A" has A_mm, A_low_mm and A_high_mm.
void setMeasure(RegistryRow& row, const std::string& name, double value_mm, double halfWidth_mm)
{
  row.set(name + "_mm", value_mm);
  row.set(name + "_low_mm", value_mm - halfWidth_mm);
  row.set(name + "_high_mm", value_mm + halfWidth_mm);
}

void setMeasure(RegistryRow& row, const std::string& name, Length value, Length error)
{
  setMeasure(row, name, inMillimeters(value), halfWidth95 * inMillimeters(error));
}

/// A field of the newest version that has these measures; empty if the record has none.
std::string savedUtcOf(const session::SavedPatient& saved)
{
  const std::string text = anatomy::patientText(saved.patient);
  for (auto each = saved.record.versions.rbegin(); each != saved.record.versions.rend(); ++each)
    if (each->patient == text) return each->savedUtc;
  return {};
}

Result<void> setDuctLength(RegistryRow& row, const anatomy::Patient& patient)
{
  const anatomy::Cochlea cochlea{sourceScaledBy(measuresOf(patient)), patient};
  const auto scala = buildAnatomy(cochlea, patient.label);
  if (!scala) return scala.error();
  const auto measures = analysis::measure(**scala, cochlea);
  const auto bands = analysis::errorBands(cochlea, measures);
  if (!bands) return bands.error();
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (measures[i].key == "cdl_oc_mm")
      setMeasure(row, "cdl_oc", measures[i].value, i < bands->size() ? (*bands)[i] : std::nan(""));
  return {};
}

Result<void> setPatient(RegistryRow& row, const session::SavedPatient& saved)
{
  const anatomy::Patient& patient = saved.patient;
  row.set("code", patient.label);
  row.set("ear", anatomy::nameOf(patient.side));
  row.set("archived", saved.record.isArchived ? "1" : "0");
  row.set("measured_utc", savedUtcOf(saved));
  row.set("measures_from", patient.seal == Seal::changed ? "changed_by_hand"
                           : isFromCt(patient)           ? "ct"
                                                         : "typed");
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  if (const auto& turn = patient.basalTurn) {
    setMeasure(row, "A", turn->a, errors.a);
    setMeasure(row, "B", turn->b, errors.b);
    if (turn->h) setMeasure(row, "H", *turn->h, errors.h.value_or(analysis::measuringError));
  } else {
    setMeasure(row, "st_length", patient.scalaTympaniLength, analysis::measuringError);
    setMeasure(row, "rw_width", patient.roundWindowWidth, analysis::measuringError);
    setMeasure(row, "rw_height", patient.roundWindowHeight, analysis::measuringError);
  }
  std::string outcome;
  for (const session::PatientOutcome& each : saved.record.outcomes)
    outcome = std::max(outcome, each.utc);
  row.set("outcome_utc", outcome);
  return setDuctLength(row, patient);
}

/// A quantity of the registry that has a band in plans.
struct PlannedQuantity {
  const char *name, *unit;
  Band ArrayPlan::*band;
};
constexpr PlannedQuantity plannedQuantities[] = {{"angle", "deg", &ArrayPlan::angle_deg},
                                                 {"depth", "mm", &ArrayPlan::depth_mm},
                                                 {"peak", "mN", &ArrayPlan::peak_mN},
                                                 {"end", "mN", &ArrayPlan::end_mN}};

/// Quantiles of a band by the part of their registryColumns' names.
constexpr std::pair<const char*, double Band::*> quantiles[] = {
    {"_", &Band::median}, {"_p5_", &Band::low}, {"_p95_", &Band::high}};

void setPlan(RegistryRow& row, const Plan& plan)
{
  const auto listed = [&plan](const auto& textOf) {
    std::string list;
    for (const ArrayPlan& each : plan.arrays)
      list += (&each == plan.arrays.data() ? "" : ";") + textOf(each);
    return list;
  };
  row.set("plan_bands_hold", bandsHold(plan));
  row.set("plan_arrays", listed([](const ArrayPlan& each) { return each.array; }));
  row.set("plan_simulations",
          listed([](const ArrayPlan& each) { return std::to_string(each.draws); }));
  for (const PlannedQuantity& quantity : plannedQuantities)
    for (const auto& [part, quantile] : quantiles)
      row.set(
          std::string("plan_") + quantity.name + part + quantity.unit,
          listed([&](const ArrayPlan& each) { return numberText(each.*quantity.band.*quantile); }));
}

void setPlanned(RegistryRow& row, const Plan& plan, const std::string& array)
{
  const auto found = std::find_if(plan.arrays.begin(), plan.arrays.end(),
                                  [&](const ArrayPlan& each) { return each.array == array; });
  if (found == plan.arrays.end() || found->draws == 0) return;
  for (const PlannedQuantity& quantity : plannedQuantities)
    for (const auto& [part, quantile] : quantiles)
      row.set(std::string("planned_") + quantity.name + part + quantity.unit,
              (*found).*quantity.band.*quantile);
  for (const auto& [name, estimate] : {std::pair{"all_inside", &ArrayPlan::allInside},
                                       {"translocated", &ArrayPlan::translocated}}) {
    const analysis::Estimate& chance = (*found).*estimate;
    const std::string column = std::string("planned_") + name;
    row.set(column + "_percent", 100.0 * chance.value);
    row.set(column + "_low_percent", 100.0 * chance.low);
    row.set(column + "_high_percent", 100.0 * chance.high);
  }
}

void setInsertion(RegistryRow& row, const analysis::RecordedResults& results)
{
  const analysis::ForceProfile& profile = results.insertion.profile;
  const auto inside = std::count_if(results.contacts.begin(), results.contacts.end(),
                                    [](const auto& each) { return each.isInserted; });
  row.set("insertion_utc", results.insertion.startedUtc);
  row.set("insertion_array", results.scenario.arrayName());
  row.set("insertion_depth_mm", inMillimeters(meters(results.deepest.output.depth)));
  if (inside > 0)
    row.set("insertion_angle_deg", inDegrees(analysis::angularInsertionDepth(results.contacts)));
  row.set("insertion_contacts_inside", std::to_string(inside));
  row.set("insertion_contacts", std::to_string(results.contacts.size()));
  row.set("insertion_peak_mN", inMillinewtons(newtons(profile.peak.force)));
  row.set("insertion_end_mN", inMillinewtons(newtons(profile.endForce)));
  row.set("insertion_outcome", haptics::nameOf(haptics::endOf(results.last)));
  const auto& translocation = results.insertion.translocation;
  row.set("insertion_translocated", translocation && translocation->lengthAbove > 0.0 ? "1" : "0");
  row.set("insertion_verified", results.verification.isIdentical ? "1" : "0");
}

/// What the folders have of all patients, the newest first.
struct Work {
  std::vector<PlanFolder> plans;
  std::vector<session::SessionSummary> sessions;
};

/// The newest plan of an ear whose numbers can be read.
std::optional<Plan> addPlan(RegistryRow& row, const anatomy::Patient& patient, const Work& work,
                            std::vector<Sentence>& notes)
{
  for (const PlanFolder& each : work.plans) {
    const anatomy::Patient& planned = each.request.patient;
    if (planned.label != patient.label || planned.side != patient.side) continue;
    if (each.shownDraws == 0) continue;  // it has no numbers yet
    auto plan = readPlan(each.folder);
    if (!plan) {
      notes.push_back(plan.error().message);
      continue;
    }
    row.set("plan_utc", each.madeUtc);
    row.set("plan_of_these_measures", session::haveSameMeasures(planned, patient) ? "1" : "0");
    setPlan(row, plan->plan);
    return std::move(plan->plan);
  }
  return std::nullopt;
}

Result<void> addInsertion(RegistryRow& row, const anatomy::Patient& patient,
                          const std::optional<Plan>& plan, const Work& work,
                          std::vector<Sentence>& notes, const std::stop_token& stop)
{
  const std::string ear = anatomy::nameOf(patient.side);
  const auto newest = std::find_if(
      work.sessions.begin(), work.sessions.end(), [&](const session::SessionSummary& each) {
        return each.patient == patient.label && each.side == ear && session::isInsertion(each);
      });
  if (newest == work.sessions.end()) return {};
  const auto results = analysis::recordedResults(newest->file, stop);
  if (stop.stop_requested()) return Error{"The registry was canceled."};
  if (!results) {
    notes.push_back(results.error().message);
    return {};
  }
  setInsertion(row, *results);
  if (plan) setPlanned(row, *plan, results->scenario.arrayName());
  return {};
}

}  // namespace

RegistryFolders ownRegistryFolders() { return {patientFolder(), plansFolder(), sessionFolder()}; }

Result<PatientRegistry> patientRegistry(const RegistryFolders& folders,
                                        const RegistryProgress& progress,
                                        const std::stop_token& stop)
{
  auto read = session::readPatients(folders.patients);
  std::sort(read.patients.begin(), read.patients.end(), [](const auto& one, const auto& other) {
    return std::pair(one.patient.label, std::string_view(anatomy::nameOf(one.patient.side))) <
           std::pair(other.patient.label, std::string_view(anatomy::nameOf(other.patient.side)));
  });
  Work work{planFoldersIn(folders.plans).plans, {}};
  auto sessions = session::listSessions(folders.recordings, folders.beingRecorded, {}, {}, stop);
  if (sessions) work.sessions = *std::move(sessions);  // else none was recorded yet

  PatientRegistry registry;
  registry.notes = std::move(read.unreadable);
  std::erase_if(read.patients, [&registry](const session::SavedPatient& each) {
    if (anatomy::checkPatientCode(each.patient.label)) return false;
    registry.notes.push_back(Sentence{
        "%1 is left out: its label is no code of letters, digits and hyphens, and may be a "
        "name. Give the patient a code.",
        each.file});
    return true;
  });
  registry.csv = headCsv(registryColumns);
  for (const session::SavedPatient& each : read.patients) {
    if (progress) progress(registry.patients, read.patients.size());
    if (stop.stop_requested()) return Error{"The registry was canceled."};
    RegistryRow row;
    if (const auto done = setPatient(row, each); !done)
      registry.notes.push_back(Sentence{"%1, %2 ear: %3", each.patient.label,
                                        std::string(anatomy::nameOf(each.patient.side)),
                                        done.error().message});
    const auto plan = addPlan(row, each.patient, work, registry.notes);
    if (const auto done = addInsertion(row, each.patient, plan, work, registry.notes, stop); !done)
      return done.error();
    registry.csv += row.csv();
    ++registry.patients;
  }
  if (progress) progress(registry.patients, registry.patients);
  return registry;
}

std::string registryDictionaryCsv() { return dictionaryCsv(registryColumns); }

}  // namespace perilymph::planning
