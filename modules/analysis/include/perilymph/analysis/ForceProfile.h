#pragma once

// Force over travel, and the few numbers an insertion is compared by.

#include <cstdint>
#include <optional>
#include <vector>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

/// A place on the curve of force over travel.
struct CurvePoint {
  double travel = 0.0;  ///< [m]
  double force = 0.0;   ///< Axial force on the hand, positive while pushing in [N].
};

/// Where a basal-turn peak is looked for. The experiment's is at 10.6 mm with raw peaks at 9 to 12
/// mm, the published simulator's at 11.2 mm; the dips behind them at 11.8 and 13.4 mm (Todd and
/// Naghdy, section III). One millimeter is left on both sides of each.
struct BasalTurnWindow {
  Length peakLow = millimeters(8), peakHigh = millimeters(13);
  Length dipHigh = millimeters(14.4);
};

/// What is left of an insertion when its ticks are gone.
struct ForceProfile {
  /// Force at every multiple of profileStep() that the tip passed for the first time, on its way
  /// in: straight lines between ticks. Starts at the first multiple at or after the starting
  /// travel.
  std::vector<CurvePoint> curve;

  CurvePoint peak;                          ///< Greatest force of any tick.
  double peakDepth = 0.0;                   ///< Depth past the opening at that tick [m].
  std::optional<CurvePoint> basalTurnPeak;  ///< See findBasalTurn().
  std::optional<CurvePoint> basalTurnDip;
  double work = 0.0;          ///< Done by the hand on the array [J]: minus the integral of F.dx.
  double finalTravel = 0.0;   ///< [m]
  double deepest = 0.0;       ///< Greatest depth past the opening [m].
  double finalDepth = 0.0;    ///< [m]
  double finalAngle = 0.0;    ///< Angle of the tip from the round window [rad].
  double duration = 0.0;      ///< Since the array began to move [s].
  double wallForceMax = 0.0;  ///< Greatest normal force of one node in any tick [N].
  double membraneForceMax = 0.0;  ///< Greatest force on the basilar membrane in any tick [N].
  std::uint64_t ticks = 0;
  std::uint64_t ticksNotConverged = 0;  ///< In which Newton's method left more than its tolerance.
};

/// Between points of ForceProfile::curve: that of the published curves.
constexpr Length profileStep() { return millimeters(0.1); }

/// Builds a profile tick by tick, in their order.
class ForceProfiler {
public:
  void add(const haptics::TickRecord& record);

  /// The profile of the ticks so far.
  ForceProfile profile() const;

private:
  void follow(const haptics::TickOutput& now);

  ForceProfile profile_;
  std::optional<haptics::TickOutput> before_;
  bool hasPeak_ = false;
  long nextPoint_ = 0;  ///< Multiple of profileStep() that the curve waits for.
};

/// The peak at the basal turn and the dip behind it.
///
/// The curve is smoothed by the mean over five points (0.5 mm). The peak is the greatest local
/// maximum of the smoothed curve within the window, the dip the least local minimum after it, both
/// with their smoothed forces. A local extremum differs from its neighbors on both sides, plateaus
/// counting as one point (their first). Nothing is found on a curve that only rises.
struct BasalTurn {
  std::optional<CurvePoint> peak, dip;
};
BasalTurn findBasalTurn(const std::vector<CurvePoint>& curve, const BasalTurnWindow& window = {});

}  // namespace perilymph::analysis
