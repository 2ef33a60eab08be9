// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What belongs to one patient's ear: scans, plans, insertions and outcomes.

#include <QString>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "gui/setup/CtRequest.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PlanStore.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// Plans and recordings of all patients.
struct PatientWork {
  std::vector<StoredPlan> plans;
  std::vector<session::SessionSummary> sessions;
};

/// Reads both folders; thousands of recordings take a second when they are first read. Any thread.
///
/// @param beingRecorded  A recording that is not finished; it may be empty.
PatientWork readPatientWork(const std::filesystem::path& beingRecorded,
                            const std::stop_token& stop);

/// One line of a patient's history.
struct HistoryEntry {
  enum class Kind { scan, plan, insertion, outcome };
  Kind kind;
  std::string utc;  ///< ISO 8601: when it was made, a scan: first saved; empty if unknown.
  QString what, values;
  QString detail;  ///< A sentence about it.
  /// A plan's folder, the recording, or the patient's file of an outcome; empty for a scan.
  std::filesystem::path place;
  CtRequest scan = {};      ///< How a scan is opened again.
  std::size_t outcome = 0;  ///< Place of an outcome in the patient's record.
};

/// The history of a patient's ear, newest first; what has no date comes last.
std::vector<HistoryEntry> historyOf(const SavedPatient& patient, const PatientWork& work);

/// "flex28 · 421 (409–433)°" of a saved outcome.
QString outcomeWords(const session::PatientOutcome& saved);

/// Date and time of an ISO 8601 text in the local zone; "–" if unknown.
QString localTimeText(const std::string& utc);

}  // namespace perilymph::gui
