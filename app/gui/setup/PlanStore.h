// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Plans on the disk: a folder for each, with patient, request, draws and notes.

#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::gui {

/// File of the draws in a plan's folder, from which an interrupted plan continues.
inline constexpr const char* planDrawsFile = "draws.sqlite";

/// File of its numbers, from which reports are made.
inline constexpr const char* planJsonFile = "plan.json";

/// A plan's folder.
struct StoredPlan {
  std::filesystem::path folder;
  planning::PlanRequest request;
  std::size_t shownDraws = 0;  ///< Draws whose bands are known; 0 before the first ones.
  bool isComplete = false;     ///< Else it was interrupted, and continues.
  std::string madeUtc;         ///< ISO 8601.
};

/// Folder of all plans: `plans` in the folder of the program's state.
std::filesystem::path plansFolder();

/// Folder of a request's plan: "P-017-left-1a2b3c4d". The last part depends on everything that the
/// plan does (planning::fingerprintOf()) and on the build of the program, not on the number of draws.
std::filesystem::path folderOfPlan(const planning::PlanRequest& request);

/// Writes patient and request into the plan's folder, which is created.
Result<void> savePlan(const StoredPlan& plan);

/// Reads them from a plan's folder.
Result<StoredPlan> readStoredPlan(const std::filesystem::path& folder);

/// The readable plans, the newest first.
std::vector<StoredPlan> storedPlans();

/// The user's notes on a plan; empty if there are none.
QString notesOf(const std::filesystem::path& folder);
Result<void> saveNotes(const std::filesystem::path& folder, const QString& notes);

}  // namespace perilymph::gui
