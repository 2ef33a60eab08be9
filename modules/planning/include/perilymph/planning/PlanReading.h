// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reading of a plan.json. Reports are made from it, so that both state the same numbers.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// Where the values of one table of a shipped file come from.
struct PlanSource {
  std::string file, table, source;
  std::string confidence;  ///< "high", "medium" or "low".
};

/// A plan as its plan.json states it: to six digits, without the insertions and the files' paths.
struct StoredPlan {
  std::string program;  ///< Version of the program that made it: "Perilymph 0.2.0".
  Plan plan;
  std::vector<PlanSource> sources;  ///< Where the distributions come from.
  std::vector<Sentence> limits;     ///< One sentence each.
  std::string text;                 ///< The plan.json.
};

/// Largest number of arrays and of contacts or depths of an array that are read.
inline constexpr std::size_t maxStoredArrays = 32, maxStoredRows = 1024;

/// Reads the text of a plan.json (planJson()).
///
/// @param name  Name of the text in error messages.
/// @return      Refuses a text that is no plan: bands whose quantiles decrease, probabilities beyond
///              0 to 1, invalid names, missing and physically impossible values. One that was
///              changed after the program wrote it is read, without its number (Plan::seal).
Result<StoredPlan> planIn(const std::string& json, const std::string& name);

/// Reads a plan's folder, or the plan.json or draws.sqlite in it.
Result<StoredPlan> readPlan(const std::filesystem::path& place);

}  // namespace perilymph::planning
