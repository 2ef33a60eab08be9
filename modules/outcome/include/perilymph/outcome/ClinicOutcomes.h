// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Outcomes of a clinic beside the plans as they were made: how often bands held, by array.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/FieldMeaning.h"
#include "perilymph/outcome/ClinicResistance.h"
#include "perilymph/outcome/FoundArray.h"
#include "perilymph/outcome/Surgery.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::outcome {

/// What a plan predicted for the array that was implanted: its simulations as they ended.
struct PlannedOutcome {
  std::vector<double> depths_mm, angles_deg;  ///< A value each simulation that could be run.
  std::optional<planning::StopDraws> stops;   ///< Absent if they cannot be computed.
  double friction = 0.0;       ///< Coefficient, static, that the plan's factors multiply.
  double insertable_mm = 0.0;  ///< Greatest depth of the array; 0 if unknown.
};

/// One implanted ear.
struct MeasuredOutcome {
  std::string surgeryUtc;  ///< Sorts the patients; is written into no file but as a year.
  std::string array;       ///< Shipped name.
  Surgery surgery;
  Uncertain depth_mm;                  ///< Inserted length of the tip past the opening.
  std::optional<Uncertain> angle_deg;  ///< Angular insertion depth.
  bool isDisplaced = false;            ///< Folded or translocated.
  PlannedOutcome plan;
};

/// Whether a value lies in the bands of 50 and 90 %.
struct BandHits {
  std::size_t all = 0, inHalf = 0, inNinety = 0;

  void add(double percentile);
  analysis::Estimate half() const { return analysis::proportionOf(inHalf, all); }
  analysis::Estimate ninety() const { return analysis::proportionOf(inNinety, all); }
};

/// Number of bins of a histogram of percentiles.
inline constexpr std::size_t percentileBins = 10;

/// One ear beside its plan.
struct ScoredOutcome {
  int year = 0;
  std::string array;
  StopReason stopReason = StopReason::unknown;
  Evidence evidence = Evidence::none;
  Uncertain depth_mm;
  planning::Band plannedDepth_mm;
  double percentile = 0.0;  ///< The depth among the plan's, 0 to 1.
  std::optional<Uncertain> angle_deg;
  planning::Band plannedAngle_deg;
  std::optional<double> anglePercentile;
  std::optional<ResistanceScore> resistance;  ///< Absent without stop lengths.
};

/// The ears with one array.
struct ArrayOutcomes {
  std::string array;  ///< Empty: all of them.
  BandHits depth, angle;
  std::array<std::size_t, percentileBins> depthPercentiles{}, anglePercentiles{};
  std::vector<double> depthDifferences_mm;  ///< Measured minus the plan's median.
};

/// Number of ears that are not compared, by reason.
struct LeftOut {
  std::size_t unreadable = 0;   ///< The patient, the record or the outcome cannot be read.
  std::size_t impossible = 0;   ///< A value that no ear has, or two that contradict each other.
  std::size_t withoutPlan = 0;  ///< No plan was made before the surgery, or it cannot be read.
  std::size_t twice = 0;        ///< The same ear or CT stands in two patients' files.
  std::size_t withoutDay = 0;   ///< The day of surgery is not known.

  std::size_t all() const { return unreadable + impossible + withoutPlan + twice + withoutDay; }
};

/// The outcomes of a clinic.
struct ClinicOutcomes {
  LeftOut leftOut;
  std::vector<ScoredOutcome> ears;    ///< In the order of surgery.
  std::vector<ArrayOutcomes> arrays;  ///< All together first, then each array, by name.
  ResistancePosterior resistance;     ///< After all of them.
  /// Depth percentiles by the clinic's resistance, as far as stop lengths are known.
  BandHits byClinic;
  AngleOffset angleOffset;
  std::optional<double>
      friction;  ///< Coefficient from which f counts; absent without stop lengths.
};

/// Percentile of a value among simulations, each widened by the error of the value, of a further value:
///
///     (sum_k Phi((x - x_k) / sd) + 1/2) / (n + 1)
double percentileAmong(const std::vector<double>& simulated, const Uncertain& measured);

/// Compares outcomes with their plans, in the order of surgery. Every ear is scored by what was known
/// before its surgery: its plan, and the lengths of those before it.
///
/// Refuses an outcome that checkOutcome() refuses.
/// @param leftOut  What whoever read the outcomes left out.
Result<ClinicOutcomes> compareOutcomes(std::vector<MeasuredOutcome> outcomes,
                                       const LeftOut& leftOut = {});
/// Refuses a depth or an angle that no array has, an inserted length beyond the array's own by three errors, an error below 0 or wider than all arrays are long, and a
/// plan without simulations, with a sentence.
/// @param name  Of the ear, for the sentence.
Result<void> checkOutcome(const MeasuredOutcome& outcome, const Sentence& name);

/// JSON text, `format` 1, sealed. Neither codes nor dates; years.
std::string outcomesJson(const ClinicOutcomes& outcomes);
/// A row an ear, in the order of surgery, and what its columns are.
std::string outcomesCsv(const ClinicOutcomes& outcomes);
std::string outcomesDictionaryCsv();
/// Columns of outcomesCsv().
const FieldMeanings& outcomesColumns();
/// What the outcomes tell about the clinic's resistance, and whether it is offered.
Sentence resistanceSentence(const ClinicOutcomes& outcomes);
/// The outcomes in sentences, for reading: Markdown.
std::string outcomesText(const ClinicOutcomes& outcomes);
/// Figures by name: "depths", predicted against measured; "percentiles", a histogram.
std::vector<std::pair<std::string, figures::Figure>> outcomesFigures(
    const ClinicOutcomes& outcomes);

}  // namespace perilymph::outcome
