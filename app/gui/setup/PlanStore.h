// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The plans of this user: a folder for each, with patient, request, draws and notes.

#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"

namespace perilymph::gui {

using planning::planDrawsFile;
using planning::planJsonFile;
using StoredPlan = planning::PlanFolder;

/// Folder of a request's plan: "P-017-left-1a2b3c4d". The last part depends on everything that the
/// plan does (planning::fingerprintOf()) and on the build of the program, not on the number of draws.
std::filesystem::path folderOfPlan(const planning::PlanRequest& request);

/// The readable plans of this user, the newest first.
std::vector<StoredPlan> storedPlans();

/// The user's notes on a plan; empty if there are none.
QString notesOf(const std::filesystem::path& folder);
Result<void> saveNotes(const std::filesystem::path& folder, const QString& notes);

}  // namespace perilymph::gui
