// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What belongs to one patient's ear: scans, plans and insertions.

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
  enum class Kind { scan, plan, insertion };
  Kind kind;
  std::string utc;  ///< ISO 8601: when it was made, a scan: first saved; empty if unknown.
  QString what, values;
  QString detail;               ///< A sentence about it.
  std::filesystem::path place;  ///< A plan's folder, or the recording; empty for a scan.
  CtRequest scan = {};          ///< How a scan is opened again.
};

/// The history of a patient's ear, newest first; what has no date comes last.
std::vector<HistoryEntry> historyOf(const SavedPatient& patient, const PatientWork& work);

/// Date and time of an ISO 8601 text in the local zone; "–" if unknown.
QString localTimeText(const std::string& utc);

}  // namespace perilymph::gui
