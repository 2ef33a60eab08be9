#pragma once

// The published experiment repeated, with the statistics of the paper: many insertions that differ
// as real ones do, a least-squares spline through each, mean and confidence over travel, and the
// difference to what was printed.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/analysis/Variability.h"

namespace perilymph::analysis {

/// What is asked of a validation.
struct ValidationRequest {
  session::Scenario scenario;  ///< The nominal insertion.
  Variability variability;
  Reference experiment;
  int runs = 200;  ///< At least 2.
  std::uint64_t seed = 1;
  unsigned jobs = 0;  ///< Threads; 0 for as many as the machine has. Leaves no trace.
  /// With one source alone: 0, or at least 2; by default a tenth of the runs, at least 10.
  std::optional<int> runsPerSource;
  /// Told the curve of each of the `runs` insertions as it ends, in whichever thread ran it.
  std::function<void(const std::vector<double>& curve)> onCurve;
  /// The scenario's cochlea, if it is built already.
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
};

/// Axis of the published curves: 0 to 16.5 mm of travel, every 0.1 mm.
constexpr Length profileEnd() { return millimeters(16.5); }

/// Mean force at one travel over all insertions.
struct ProfilePoint {
  double travel = 0.0;  ///< [m]
  SampleStatistics force;
};

/// A printed value of the experiment beside the insertions' own.
struct AnchorComparison {
  PrintedForce experiment;
  SampleStatistics simulator;
  SampleStatistics difference;  ///< Simulator minus experiment.
  bool isWithinStandardDeviation = false;
};

/// How much of the spread one source makes when it acts alone.
struct SourceSpread {
  SpreadSource source = SpreadSource::start;
  double standardDeviation = 0.0;  ///< Root mean square over travel of the standard deviation [N].
  double fraction = 0.0;           ///< Fraction of the sum of the variances of all sources alone.
};

/// What the raw record says where the first marker rib meets the opening, means over insertions.
struct RibMeeting {
  double depth = 0.0;       ///< Depth of the rib from the tip [m].
  SampleStatistics before;  ///< Force from 1.0 to 0.5 mm before it [N].
  SampleStatistics peak;    ///< Greatest force within 0.5 mm of it [N].
};

struct ValidationResult {
  std::vector<ProfilePoint> profile;
  std::vector<AnchorComparison> anchors;
  BasalTurn basalTurn;                  ///< Peak and dip of the mean curve.
  std::optional<CurvePoint> earlyPeak;  ///< At 3 to 7 mm, if the force falls by 1 mN behind it.
  std::optional<RibMeeting> rib;        ///< Where the array has ribs.
  double standardDeviation = 0.0;       ///< Root mean square over travel of the SD [N].
  std::vector<SourceSpread> spreads;
  std::uint64_t ticks = 0, ticksNotConverged = 0;
  int runs = 0;
  std::uint64_t seed = 0;
};

/// Told how many insertions of how many are done; false stops.
using ValidationProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Runs it. The same request gives the same result, bit for bit, whatever `jobs` is.
Result<ValidationResult> validate(const ValidationRequest& request,
                                  const ValidationProgress& progress);

/// Force over travel of one insertion: least squares, resampled at every multiple of profileStep()
/// up to profileEnd(). Nothing if the samples are too few for the spline.
std::optional<std::vector<double>> resampled(const std::vector<double>& travel,
                                             const std::vector<double>& force, Length knotSpacing);

}  // namespace perilymph::analysis
