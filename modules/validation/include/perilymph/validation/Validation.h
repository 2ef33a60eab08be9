// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Repetition of the published experiment with the statistics of the paper: many varied insertions,
// a least-squares spline through each, mean and confidence interval over travel, and the difference
// to the printed values.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/validation/IncompleteInsertion.h"
#include "perilymph/validation/Variability.h"

namespace perilymph::validation {

/// Input of a validation.
struct ValidationRequest {
  session::InsertionParameters nominal;  ///< The insertion that the others vary.
  Variability variability;
  analysis::Reference experiment;
  int runs = 200;  ///< At least 2.
  std::uint64_t seed = 1;
  unsigned jobs = 0;  ///< Threads; 0: one per processor. Does not affect results.
  /// Insertions per single source of variation: 0, or at least 2; by default a tenth of the runs,
  /// at least 10.
  std::optional<int> runsPerSource;
  /// Receives the curve of each of the `runs` insertions that is complete when it ends, in the thread that ran it.
  std::function<void(const std::vector<double>& curve)> onCurve;
  /// The nominal insertion's cochlea, if already built.
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
};

/// Axis of the published curves: 0 to 16.5 mm of travel, every 0.1 mm.
constexpr Length profileEnd() { return millimeters(16.5); }

/// Mean force over all insertions at one travel.
struct ProfilePoint {
  double travel = 0.0;  ///< [m]
  analysis::SampleStatistics force;
};

/// A printed value of the experiment compared with the insertions.
struct AnchorComparison {
  analysis::PrintedForce experiment;
  analysis::SampleStatistics simulator;
  analysis::SampleStatistics difference;  ///< Simulator minus experiment.
  bool isWithinStandardDeviation = false;
};

/// An interval of the experiment compared with the insertions.
struct IntervalComparison {
  analysis::PrintedInterval experiment;
  analysis::SampleStatistics simulator;
  double difference = 0.0;     ///< Simulator minus the nearer end; 0 within the interval [N].
  double standardError = 0.0;  ///< Standard error of the difference [N].
};

/// Feature of the printed force that the shipped calibration fits; every other one is predicted.
inline constexpr const char* fittedFeature = "peak";

/// How well the insertions meet the predicted forces of the experiment.
struct Agreement {
  double largest = 0.0;  ///< Largest difference, of either sign [N].
  /// Sum of squared differences in standard errors of the experiment's and the simulator's means.
  double chiSquare = 0.0;
  int degreesOfFreedom = 0;  ///< Number of predicted forces.
  /// Probability of a chi-square at least this large if the model were right and only the means
  /// uncertain.
  double pValue = 1.0;
};

/// Spread caused by one source of variation alone.
struct SourceSpread {
  SpreadSource source = SpreadSource::start;
  double standardDeviation = 0.0;  ///< Root mean square over travel of the standard deviation [N].
  double fraction = 0.0;           ///< Fraction of the sum of the variances of all sources alone.
};

/// Forces in the raw record where the first marker rib reaches the opening, means over insertions.
struct RibEntry {
  double depth = 0.0;  ///< Distance of the rib from the tip, which is the depth then [m].
  analysis::SampleStatistics before;  ///< Force from 1.0 to 0.5 mm before it [N].
  analysis::SampleStatistics peak;    ///< Maximum force within 0.5 mm of it [N].
};

struct ValidationResult {
  std::vector<ProfilePoint> profile;
  std::vector<AnchorComparison> anchors;
  std::vector<IntervalComparison> intervals;
  analysis::BasalTurn basalTurn;  ///< Peak and dip of the mean curve.
  std::optional<analysis::CurvePoint>
      earlyPeak;  ///< At 3 to 7 mm, if the force then falls by 1 mN.
  std::optional<analysis::SampleStatistics>
      rawPeak;                     ///< Maximum of each raw record at 9 to 12 mm [N].
  std::optional<RibEntry> rib;     ///< Only if the array has ribs.
  double standardDeviation = 0.0;  ///< Root mean square over travel of the SD [N].
  std::vector<SourceSpread> spreads;
  std::uint64_t ticks = 0, ticksNotConverged = 0;
  int runs = 0;  ///< All insertions, complete or not.
  /// Those of them that did not reach full travel; statistics are over the others.
  std::vector<IncompleteInsertion> incomplete;
  std::uint64_t seed = 0;
};

/// Runs a validation. The same request gives the same result, bit for bit, for any `jobs`. An
/// insertion that does not reach full travel is counted; an error if fewer than two reach it.
/// `stop` ends the work early, with an error.
Result<ValidationResult> validate(const ValidationRequest& request,
                                  const analysis::RunProgress& progress = {},
                                  const std::stop_token& stop = {});

/// Agreement with all forces of the experiment but the fitted one.
Agreement agreementOf(const ValidationResult& result);

/// Probability that a chi-square variable is at least `chiSquare`; 1 without a degree of freedom.
double chiSquareTail(double chiSquare, int degreesOfFreedom);
/// The value that a chi-square variable with at least one degree of freedom exceeds with a
/// probability between 0 and 1.
double chiSquareExceededBy(double probability, int degreesOfFreedom);

/// Standard deviations sigma of a population that are compatible with the standard deviation s of n
/// normal values, 95 %: (n - 1) s^2 / sigma^2 is a chi-square variable with n - 1 degrees of freedom.
/// Unbounded for fewer than two values.
Range deviationsBehind(double deviation, double insertions);

/// Force over travel of one insertion: least-squares fit, resampled at every multiple of
/// profileStep() up to profileEnd(). Empty if there are too few samples for the spline.
std::optional<std::vector<double>> resampled(const std::vector<double>& travel,
                                             const std::vector<double>& force, Length knotSpacing);

}  // namespace perilymph::validation
