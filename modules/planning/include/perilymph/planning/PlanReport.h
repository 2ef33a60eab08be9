// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A plan as files: JSON, tables and figures. The same plan gives the same bytes.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/PhysicalRanges.h"
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
  bool isInFirstVersions = true;
  const char* formerKey = nullptr;  ///< Its name in files before format 3, read until version 1.0.
};
/// All of them, in the order of the files.
std::span<const PlanProbability> planProbabilities();

/// A quantity of an array at the median friction.
struct FrictionQuantity {
  const char* key;
  Band AtMedianFriction::*band;
  Range range;
};
inline constexpr FrictionQuantity frictionQuantities[] = {
    {"angle_deg", &AtMedianFriction::angle_deg, analysis::physical::angle_deg},
    {"depth_mm", &AtMedianFriction::depth_mm, analysis::physical::depth_mm},
    {"peak_mN", &AtMedianFriction::peak_mN, analysis::physical::force_mN},
    {"end_mN", &AtMedianFriction::end_mN, analysis::physical::signedForce_mN}};

/// A quantity of a difference of two arrays that has a band.
struct DifferenceQuantity {
  const char* key;
  Band ArrayDifference::*band;
  Range range;
};
/// Range of the difference of two values.
constexpr Range differenceOf(Range values)
{
  return {values.low - values.high, values.high - values.low};
}
inline constexpr DifferenceQuantity differenceQuantities[] = {
    {"angle_deg", &ArrayDifference::angle_deg, differenceOf(analysis::physical::angle_deg)},
    {"depth_mm", &ArrayDifference::depth_mm, differenceOf(analysis::physical::depth_mm)},
    {"peak_mN", &ArrayDifference::peak_mN, differenceOf(analysis::physical::force_mN)}};

/// A probability in a difference of two arrays.
struct DifferenceProbability {
  const char* key;
  analysis::Estimate ArrayDifference::*estimate;
};
inline constexpr DifferenceProbability differenceProbabilities[] = {
    {"first_is_deeper", &ArrayDifference::deeper},
    {"first_has_higher_peak", &ArrayDifference::harder}};

/// Version of the text of planJson(); 1, without the number, had no seal; 2 called the probability
/// `intended_depth_reached` `full_insertion`.
inline constexpr std::uint64_t planFormat = 3, firstSealedPlanFormat = 2;

/// The whole plan with its seal: patient, arrays with bands and probabilities, what was drawn and from where, what
/// was not, versions. An error if a shipped source cannot be read, and for a plan that was read
/// without an intact seal, which would get one.
Result<std::string> planJson(const Plan& plan);

/// One row per array: draws, bands of angle, coverage, depth and forces, probabilities in percent, bands
/// at the median friction (empty where it has no stated spread).
std::string arraysCsv(const Plan& plan);

/// One row per pair of arrays: bands of the first minus the second in the same ear, with the same hand
/// and friction; how often the first is deeper and has the higher peak force, in percent.
std::string differencesCsv(const Plan& plan);

/// Figures by name: "angle", the angular insertion depths side by side; "force-1", "force-2", ...,
/// the force over depth with its bands, and "influence-1", ..., ranked bars of what the bands' width
/// rests on.
std::vector<std::pair<std::string, figures::Figure>> planFigures(const Plan& plan);

/// What a plan leaves open besides what it draws, one sentence each.
const std::vector<Sentence>& limitsOfPlans();
/// What a plan that was asked to use a clinic's resistance adds to them.
Sentence clinicSentence(const ClinicSource& clinic);
/// Such sentences of former versions, by which their files are shown in another language.
const std::vector<Sentence>& formerLimitsOfPlans();

}  // namespace perilymph::planning
