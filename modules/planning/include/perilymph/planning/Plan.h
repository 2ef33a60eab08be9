// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A plan: electrode arrays in one patient's cochlea, with bands for what measures, hand, approach and
// stiffness leave open. Values are those of the model, none is a recommendation.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ClinicalPrediction.h"
#include "perilymph/analysis/InParallel.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Seal.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::planning {

/// Nodes of the array and time step of a plan's insertions: a longer step than the scenario's, a third
/// of the time. With them every straight array that buckles does so within 5 degrees of 400 nodes and
/// 1 ms (test/physics/ends); with 50 nodes some were 9 off. The bands: test/physics/plan.
struct Resolution {
  int nodes = 100;
  Duration step = milliseconds(5);  ///< At most 10 ms, which an engine accepts.
};

/// Input of a plan.
struct PlanRequest {
  anatomy::Patient patient;         ///< With A and B; H and the errors of all three if known.
  std::vector<std::string> arrays;  ///< Shipped names or files.
  std::string scenario = "surgery-flex28";  ///< Defines everything that is neither drawn nor named.
  std::optional<std::string> friction;      ///< Shipped name or file; without it, the scenario's.
  std::size_t draws = 64;                   ///< At most.
  /// Whether fewer draws are run if the bands stand earlier (see bandsStand()).
  bool stopsEarly = true;
  std::uint64_t seed = 1;
  /// Without one, the scenario's own nodes and time step.
  std::optional<Resolution> resolution = Resolution{};
  unsigned jobs = 0;  ///< Threads; 0: one per processor. Does not affect the plan.
};

/// The scenario of a request with one of its arrays.
///
/// @param stopTravel_mm  Decimal text, such as session::anyStopTravel until the array's is known.
Result<session::Scenario> scenarioOf(const PlanRequest& request, const std::string& array,
                                     const std::string& stopTravel_mm);

/// Smallest and largest number of draws. The extremes of 16 hold 88 % of what is to come; of 8, 78 %.
inline constexpr std::size_t fewestDraws = 16, maxDraws = 4096;
/// Refuses numbers of draws that no user is offered. makePlan() itself takes one draw: a window shows
/// first bands of few, and tests are cheap. Programs take few if PERILYMPH_FEW_DRAWS is set, which
/// their results name (Version.h).
Result<Done> checkDraws(std::size_t draws);
/// Distance between the depths of a force band.
inline constexpr Length bandSpacing = millimeters(0.5);

/// One array in one draw.
struct PlannedInsertion {
  std::size_t draw = 0;                       ///< From 1.
  std::size_t array = 0;                      ///< Index into PlanRequest::arrays.
  double a_mm = 0.0, b_mm = 0.0, h_mm = 0.0;  ///< As drawn; H 0 if the patient has none.
  /// How A and B are shared between both sides of the axis: deviates of the population.
  double a1_deviate = 0.0, b1_deviate = 0.0;
  /// Factor of the sections' width and height at the base (90 degrees) and in the second turn (450).
  double section = 1.0, sectionSecond = 1.0;
  /// Height of the center line at 90 degrees above the middle of its heights at 0 and 180, beyond the
  /// mean course: the dip or peak of the basal turn.
  double dip_mm = 0.0;
  double radius = 1.0;  ///< Factor of the outer wall's distance from the axis at 180 degrees.
  double height = 1.0;  ///< Factor of the mean shape's H; 1 if it was measured.
  double lining_mm = 0.0, membrane_N_m = 0.0;
  double tilt_deg = 0.0, turn_deg = 0.0;  ///< From the scenario's approach.
  double stiffness = 1.0;                 ///< Factor of the array's.
  double friction = 1.0;                  ///< Factor of the scenario's.
  double speed_mm_s = 0.0;
  double stop_mN = 0.0;  ///< Force at which the surgeon stops.
  analysis::ClinicalInsertion insertion;
};

/// Quantiles of a quantity over the draws.
struct Band {
  double low = 0.0, lowerQuartile = 0.0, median = 0.0, upperQuartile = 0.0, high = 0.0;
};
/// The band of some values: 5, 25, 50, 75 and 95 % of the cochlea and hand to come; zeros without a
/// value, as if no insertion of an array could be prepared. The i-th
/// of n sorted draws is the quantile i / (n + 1), whose expectation no distribution changes
/// (Hyndman and Fan 1996, Am Stat 50:361, definition 6); below 19 draws low and high are the extremes
/// and hold less than 90 %.
Band bandOf(std::vector<double> values);

/// Force at a depth over the draws whose tip came that deep.
struct ForceBand {
  double depth_mm = 0.0;
  std::size_t draws = 0;
  Band force_mN;
};

/// One contact over the draws in which it is inserted.
struct ContactBand {
  int number = 0;  ///< 1 at the tip.
  std::size_t draws = 0;
  Band angle_deg, toModiolus_mm;
  double greenwood_Hz = 0.0;       ///< At the median of its place along the organ of Corti.
  double spiralGanglion_Hz = 0.0;  ///< At the median of its angle.
  double filter_Hz = 0.0;          ///< Center of its default filter; 0 if no allocation is known.
  /// Frequency of its place on the spiral ganglion above its filter's center; positive: it hears
  /// a lower frequency than its place. Zeros without a filter.
  Band mismatch_semitones;
};

/// How much of an outcome's variance an input explains: squared rank correlation (Spearman 1904),
/// adjusted for what chance gives it in as many draws, 1 - (1 - r^2) (n - 1) / (n - 2) or 0. Inputs
/// are independent; were one known, the outcome's deviation and band would be sqrt(1 - r^2) as wide.
struct Influence {
  std::string input;
  double onAngle = 0.0, onPeak = 0.0;
  double angleWidth_deg = 0.0, peakWidth_mN = 0.0;  ///< From 5 to 95 %, if the input were known.
  /// The angle's width if A, B or H, whichever this is, were measured to `finerError`; 0 for other
  /// inputs and for a measure that is as exact already.
  double finerAngleWidth_deg = 0.0;
};
/// Standard deviation of a finer measurement of A, B or H: an isotropic voxel of 0.2 mm halved
/// (choice, medium).
inline constexpr Length finerError = millimeters(0.1);

/// One array over all draws.
struct ArrayPlan {
  std::string array;  ///< As in the request.
  std::string name;   ///< "FLEX28".
  std::size_t draws = 0;
  Band angle_deg;         ///< Angle of the most apical contact.
  Band coverage_percent;  ///< Organ of Corti basal to it.
  Band depth_mm;          ///< Depth of the tip past the opening.
  Band peak_mN, end_mN;   ///< Axial, on the hand; at the end of the push.
  /// The same after 1 s and 10 s of rest; zeros if it was not computed.
  Band after1s_mN, after10s_mN;
  Band partition_mN;             ///< Maximum force on the cochlear partition.
  analysis::Estimate full;       ///< Probability of full depth, with its 95 % interval.
  analysis::Estimate resisted;   ///< That the surgeon stops by resistance.
  analysis::Estimate buckled;    ///< That the array bows in front of the opening.
  analysis::Estimate foldedTip;  ///< That the tip folds over.
  analysis::Estimate other;      ///< That it ends otherwise: out of the opening, jammed, refused.
  analysis::Estimate ruptured;   ///< That the partition ruptures, at its drawn strength.
  analysis::Estimate translocated;  ///< That a part of the array ends in the scala vestibuli.
  /// That the force on the partition reaches the weakest, and the strongest published partition's
  /// strength (Thresholds).
  analysis::Estimate reachesWeakest, reachesStrongest;
  /// Depth at which the axial force first reaches Thresholds::felt, over the draws in which it does.
  Band firstResistance_mm;
  analysis::Estimate felt;       ///< That it does.
  std::vector<ForceBand> force;  ///< At multiples of `bandSpacing`.
  std::vector<ContactBand> contacts;
  std::vector<Influence> influences;  ///< The largest on the angle first.
};

/// What a summary knows of an array before it is inserted.
struct PlannedArray {
  std::string name;               ///< "FLEX28".
  std::vector<double> filter_Hz;  ///< Centers of the default filters from the tip, if known.
};

/// Forces that results are compared with.
struct Thresholds {
  Force felt;                     ///< First resistance: the median force that surgeons detect.
  Force ruptureLow, ruptureHigh;  ///< Published range of the strength of the cochlear partition.
};

/// A plan.
struct Plan {
  PlanRequest request;
  Thresholds thresholds;
  /// Lowest and highest coefficient of the friction that every insertion has, but for its drawn
  /// factor; without bounds if the plan.json does not state it.
  Range friction;
  /// Its number: SHA-256 of everything it depends on but `draws` and `jobs`. Empty for a plan that
  /// was changed after the program wrote it.
  std::string fingerprint;
  Seal seal = Seal::intact;                  ///< State of the file that it was read from.
  std::vector<PlannedInsertion> insertions;  ///< By draw, then by array.
  std::vector<ArrayPlan> arrays;
  /// Whether everything it depends on is still as it was. Otherwise it is shown as it was made, but
  /// not continued and no draw of it is run again.
  bool isCurrent = true;
};

/// Summaries of a request's arrays from insertions by draw and array.
std::vector<ArrayPlan> summarize(const PlanRequest& request,
                                 const std::vector<PlannedArray>& arrays,
                                 const Thresholds& thresholds,
                                 const std::vector<PlannedInsertion>& insertions);

/// Whether the bands of all arrays stand: the standard errors of the median angle and of the median
/// peak force are at most 5 degrees and 5 % (choices, medium).
bool bandsStand(const std::vector<ArrayPlan>& arrays);

/// Makes a plan. Every draw is a cochlea, an approach, a hand and a stiffness, the same for all
/// arrays. Draws are kept in a file as they are done: a plan that was interrupted continues there,
/// and is the same, to the bit, for any number of threads and interruptions.
///
/// @param draws  File of the draws (`.sqlite`), created or continued; in memory only if empty.
/// @param stop   Ends the work early, with an error.
/// @return       Refuses a patient without A and B, unknown arrays, a file of another plan.
Result<Plan> makePlan(const PlanRequest& request, const std::filesystem::path& draws,
                      const analysis::RunProgress& progress = {}, const std::stop_token& stop = {});

/// Reads a plan from its file of draws, as it was made; computes no insertion. If an array, the
/// scenario, a distribution, a threshold, a filter or the program was changed since, thresholds and filters are those of the
/// plan.json beside the file.
///
/// @param request  As for makePlan(); of its draws exactly as many are read.
/// @param draws    File of the draws, which is not written to.
/// @return         Refuses a file with fewer draws, and a changed plan without a plan.json.
Result<Plan> viewPlan(const PlanRequest& request, const std::filesystem::path& draws);

/// Plan::fingerprint of a request, before a plan is made. Refuses what makePlan() refuses.
Result<std::string> fingerprintOf(const PlanRequest& request);

}  // namespace perilymph::planning
