// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Force over travel, and the key figures of an insertion.

#include <cstdint>
#include <optional>
#include <vector>

#include "perilymph/analysis/RunningMean.h"
#include "perilymph/analysis/StopForce.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// A point of the force-travel curve.
struct CurvePoint {
  double travel = 0.0;  ///< [m]
  double force = 0.0;   ///< Axial force on the hand, positive while pushing in [N].
};

/// Search range of a basal-turn peak. The experiment's peak is at 10.6 mm with raw peaks at 9 to 12
/// mm, the published simulator's at 11.2 mm; the dips behind them are at 11.8 and 13.4 mm (Todd and
/// Naghdy, section III). The range is one millimeter wider on both sides.
struct BasalTurnWindow {
  Length peakLow = millimeters(8), peakHigh = millimeters(13);
  Length dipHigh = millimeters(14.4);
};

/// Summary of an insertion.
struct ForceProfile {
  /// Force at every multiple of profileStep() where the tip first passed it on insertion, linearly
  /// interpolated between ticks. Starts at the first multiple at or after the initial travel.
  std::vector<CurvePoint> curve;

  CurvePoint peak;                          ///< Maximum force of any tick.
  double peakDepth = 0.0;                   ///< Depth past the opening at that tick [m].
  std::optional<CurvePoint> basalTurnPeak;  ///< See findBasalTurn().
  std::optional<CurvePoint> basalTurnDip;
  double work = 0.0;  ///< Work of the hand on the array [J]: minus the integral of F.dx.
  /// StopForce over `averaged` where the insertion ends, or without an end at the maximum depth [N].
  double endForce = 0.0;
  /// Mean force over the last `averaged` of 1 s of rest there; empty if the hand did not rest as long [N].
  std::optional<double> forceAfter1s;
  double finalTravel = 0.0;   ///< [m]
  double deepest = 0.0;       ///< Maximum depth past the opening [m].
  double finalDepth = 0.0;    ///< [m]
  double finalAngle = 0.0;    ///< Angle of the tip from the round window [rad].
  double deepestAngle = 0.0;  ///< Maximum angle of the tip [rad].
  double duration = 0.0;      ///< From the first to the last motion, pauses included [s].
  double wallForceMax = 0.0;  ///< Maximum normal force on one node in any tick [N].
  double partitionForceMax =
      0.0;  ///< Maximum force on the cochlear partition within one contact, in
            ///< any tick [N]; NaN if an earlier version did not record it.
  std::uint64_t ticks = 0;
  std::uint64_t ticksNotConverged = 0;  ///< Ticks in which the residual exceeded the tolerance.
};

/// Spacing of the points of ForceProfile::curve: that of the published curves.
constexpr Length profileStep() { return millimeters(0.1); }

/// Time over which the force at the stop and at rest is read, as in plans.
constexpr Duration averaged() { return seconds(0.5); }

/// Rest after which the force is stated as that after 1 s.
constexpr Duration shortRest() { return seconds(1); }

/// Builds a profile tick by tick, in order.
class ForceProfiler {
public:
  void add(const haptics::TickRecord& record);

  /// The profile of the ticks so far.
  ForceProfile profile() const;
  /// ForceProfile::work of the ticks so far [J].
  double work() const noexcept { return profile_.work; }

private:
  void follow(const haptics::TickOutput& now);
  void followRest(const haptics::TickOutput& now);

  ForceProfile profile_;
  StopForce stop_{averaged()};
  bool isDeepest_ = false;        ///< The tick before was the deepest.
  RunningMean rest_{averaged()};  ///< The force after the end [N].
  std::optional<double> ended_;   ///< Time at which the insertion ended [s].
  bool isWithdrawn_ = false;      ///< After it.
  std::optional<haptics::TickOutput> before_;
  long nextPoint_ = 0;  ///< Multiple of profileStep() of the next point.
};

/// The peak at the basal turn and the dip behind it.
///
/// The curve is smoothed by the mean over five points (0.5 mm). The peak is the largest local
/// maximum of the smoothed curve within the window, the dip the smallest local minimum after it,
/// both with their smoothed forces. A local extremum differs from its neighbors on both sides; a
/// plateau counts as one point (its first). A monotonically rising curve has neither.
struct BasalTurn {
  std::optional<CurvePoint> peak, dip;
};
BasalTurn findBasalTurn(const std::vector<CurvePoint>& curve, const BasalTurnWindow& window = {});

}  // namespace perilymph::analysis
