// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Plans on the disk: a folder for each, with patient, request, draws and plan.json.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanRequest.h"

namespace perilymph::planning {

/// Names of the files in a plan's folder: the patient, the request, the draws from which an interrupted
/// plan continues, and the numbers from which reports are made.
inline constexpr const char *planPatientFile = "patient.toml", *planRequestFile = "plan.toml",
                            *planDrawsFile = "draws.sqlite", *planJsonFile = "plan.json";

/// A plan's folder.
struct PlanFolder {
  std::filesystem::path folder;
  PlanRequest request;
  std::size_t shownDraws = 0;  ///< Draws whose bands are known; 0 before the first ones.
  bool isComplete = false;     ///< Else it was interrupted, and continues.
  std::string madeUtc;         ///< ISO 8601.
};

/// The files plan.toml and patient.toml of a plan's folder: names and texts. Arrays, friction and resistance
/// that are given as files have absolute paths, so that the folder can be moved.
std::vector<std::pair<std::string, std::string>> requestFiles(const PlanFolder& plan);

/// Writes them into the plan's folder, which is created.
Result<void> savePlanFolder(const PlanFolder& plan);

/// Reads patient and request from a plan's folder.
Result<PlanFolder> readPlanFolder(const std::filesystem::path& folder);

struct PlanFolders {
  std::vector<PlanFolder> plans;     ///< The newest first.
  std::vector<Sentence> unreadable;  ///< Why a plan that is there cannot be read, with its file.
};

/// The plans in a folder of plans; none of a folder that does not exist.
PlanFolders planFoldersIn(const std::filesystem::path& plans);

}  // namespace perilymph::planning
