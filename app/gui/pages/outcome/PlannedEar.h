// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a patient's ear was planned and practiced with: plan, insertion by hand, scala tympani.

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "gui/setup/PatientHistory.h"
#include "perilymph/analysis/Comparison.h"
#include "perilymph/outcome/ClinicOutcomes.h"
#include "perilymph/planning/PlanReading.h"

namespace perilymph::gui {

/// The ear of a patient with one array.
struct PlannedEar {
  std::string array;  ///< Shipped name; empty if the patient has neither plan nor insertion.
  std::shared_ptr<const planning::StoredPlan> plan;  ///< Null without one of this array.
  std::size_t place = 0;                             ///< Place of the array in the plan.
  std::string planMadeUtc;
  outcome::PlannedOutcome ends;  ///< Its simulations as they ended; empty where they are not there.
  /// The patient's newest insertion of this array.
  std::optional<analysis::ComparedInsertion> insertion;
  std::shared_ptr<const anatomy::ScalaTympani> scala;  ///< From the patient's measures.

  const planning::ArrayPlan* arrayPlan() const
  {
    return plan ? &plan->plan.arrays[place] : nullptr;
  }
};

/// Reads plan and insertion, and builds the cochlea; a second. Any thread.
///
/// @param array          Empty for that of the newest insertion, or of the newest plan.
/// @param plan           Number of the plan; empty for the newest that was made before surgery, else the newest.
/// @param surgeryDay     "2026-11-20"; empty where it is not known.
/// @param beingRecorded  A recording that is not finished; it may be empty.
Result<PlannedEar> plannedEar(const anatomy::Patient& patient, const std::string& array,
                              const std::string& plan, const std::string& surgeryDay,
                              const std::filesystem::path& beingRecorded,
                              const std::stop_token& stop);

}  // namespace perilymph::gui
