// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A plan as files: JSON, tables and figures. The same plan gives the same bytes.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// A quantity of an array's plan that has a band.
struct PlanQuantity {
  const char* key;  ///< Its name in files, with its unit.
  Band ArrayPlan::*band;
  Range range;  ///< What it can be.
  bool isInFirstVersions = true;
};
/// All of them, in the order of the files.
std::span<const PlanQuantity> planQuantities();

/// A probability in an array's plan.
struct PlanProbability {
  const char* key;  ///< Its name in files.
  analysis::Estimate ArrayPlan::*estimate;
};
/// All of them, in the order of the files.
std::span<const PlanProbability> planProbabilities();

/// Version of the text of planJson(); 1, without the number, had no seal.
inline constexpr std::uint64_t planFormat = 2;

/// The whole plan with its seal: patient, arrays with bands and probabilities, what was drawn and from where, what
/// was not, versions. An error if a shipped source cannot be read, and for a plan that was read
/// without an intact seal, which would get one.
Result<std::string> planJson(const Plan& plan);

/// One row per array: draws, bands of angle, coverage, depth and forces, probabilities in percent.
std::string arraysCsv(const Plan& plan);

/// One row per contact of each array: angle and distance with bands, frequencies.
std::string contactsCsv(const Plan& plan);

/// Figures by name: "angle", the angular insertion depths side by side; "force-1", "force-2", ...,
/// the force over depth with its bands, and "influence-1", ..., ranked bars of what the bands' width
/// rests on.
std::vector<std::pair<std::string, figures::Figure>> planFigures(const Plan& plan);

/// What a plan leaves open besides what it draws, one sentence each.
const std::vector<Sentence>& limitsOfPlans();
/// Such sentences of former versions, by which their files are shown in another language.
const std::vector<Sentence>& formerLimitsOfPlans();

}  // namespace perilymph::planning
