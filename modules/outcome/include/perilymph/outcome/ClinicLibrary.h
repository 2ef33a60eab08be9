// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The outcomes of the saved patients with the plans that were made before their surgery.

#include <stop_token>
#include <vector>

#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/outcome/ClinicOutcomes.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/planning/PatientRegistry.h"

namespace perilymph::outcome {

struct LibraryOutcomes {
  std::vector<MeasuredOutcome> outcomes;
  std::vector<anatomy::Patient> patients;  ///< Whose each of them is, for the user alone.
  LeftOut leftOut;
  /// What was left out or is doubtful, and why, a sentence each. They name codes and are for the user alone.
  std::vector<Sentence> notes;
};

/// Whether stop lengths are computed, which a comparison of depths does not need.
enum class StopLengths { computed, leftOut };

/// Reads the newest outcome of every saved ear and the plan whose number it states, else the newest plan of
/// that ear with the array. Stop lengths are computed where an outcome tells something about resistance, which
/// takes as long as the plan once; of a plan that something was changed since, they cannot be.
///
/// An ear is left out, with a sentence, and the others are read: a file or an outcome that cannot be read, a
/// value that checkOutcome() refuses, two statements that contradict each other (array, side, depth, series),
/// a day of saving to come, a day of surgery that is not known, no plan that was made before the surgery and not
/// changed since, an ear in two files, and a CT that two patients have. compareOutcomes() takes all outcomes that are returned.
///
/// @param folders  Folders of patients and plans.
/// @param stop     Ends it early, with an error.
Result<LibraryOutcomes> readOutcomes(const planning::RegistryFolders& folders,
                                     const analysis::RunProgress& progress = {},
                                     const std::stop_token& stop = {},
                                     StopLengths lengths = StopLengths::computed);

/// Depths and angles of a plan's array as its simulations ended, without those that could not be run.
/// @param array  Its place in the plan's request.
PlannedOutcome endsOf(const planning::Plan& plan, std::size_t array);

/// A number of days before the day of a time, "2026-11-20T09:30:00Z", or before a day: "2026-11-18". Empty if that
/// is neither.
std::string dayBefore(const std::string& utc, int days);
/// The day of the CT of an outcome, from when it was saved: "2026-11-20"; empty where it is not known.
std::string ctDayOf(const OutcomeContent& content, const std::string& savedUtc);
/// The day of surgery, from the day of the CT and what the surgeon states; empty where either is not known.
std::string surgeryDay(const std::string& ctDay, const Surgery& surgery);
/// Whether a plan predicts: it was made at the latest on the day of surgery, and that is known.
bool isPrediction(const std::string& planMadeUtc, const std::string& surgeryDay);

}  // namespace perilymph::outcome
