// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Statistics of one visitor's insertion, for the list.

#include <vector>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// Tracks an insertion through its snapshots: maximum depth, number of reversals, force over travel.
/// The peak force is that of every tick, which the engine finds.
class VisitorSession {
public:
  /// Adds one snapshot.
  void follow(const haptics::Snapshot& snapshot);

  double peakForce() const { return peakForce_; }          ///< [N]
  double deepestTravel() const { return deepestTravel_; }  ///< [m]
  double deepest() const { return deepest_; }              ///< Insertion depth [m].
  double duration() const { return duration_; }            ///< Since the first motion [s].
  int reversals() const { return reversals_; }
  /// ForceProfile::curve, linearly interpolated between snapshots instead of ticks: of a finger's
  /// fastest insertion, 6 mm/s, there is one every 0.1 mm.
  std::vector<analysis::CurvePoint> curve() const { return profiler_.profile().curve; }

private:
  analysis::ForceProfiler profiler_;
  double peakForce_ = 0.0;
  double deepestTravel_ = 0.0;
  double deepest_ = 0.0;
  double duration_ = 0.0;
  int reversals_ = 0;
  double turning_ = 0.0;  ///< Travel at the last reversal, or the extreme since then [m].
  bool isAdvancing_ = true;
};

}  // namespace perilymph::gui
