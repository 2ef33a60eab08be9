// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Detects the events that end an insertion before its stop travel.

#include <Eigen/Core>
#include <cstddef>

#include "perilymph/foundation/Hash.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::haptics {

/// Hand force above which an insertion is jammed [N]. Peaks in vivo are below 0.11 N (Rau 2024, doi
/// 10.3389/fneur.2024.1400455), sums of forces over whole insertions below 2 N (Nguyen 2014, doi
/// 10.1155/2014/532570); the limit is a choice (medium).
inline constexpr double maxHandForce = 2.0;

/// Thresholds of the shape [m]; choices (medium).
struct EndLimits {
  /// Array outside, less the straight distance to the opening: a shallow bow of length l and height
  /// a takes (pi a)^2 / (4 l); 4 mm on 20 mm are a bow of 6 mm. Completed insertions of the
  /// published experiment take less than 1 mm.
  double maxSlack = 4e-3;
  /// The same while the tip is outside: it is pushed past the opening, not drawn out of it.
  double slippedSlack = 0.5e-3;
  /// Array pushed in while the tip stays within `minAdvance`.
  double maxStall = 3e-3;
  double minAdvance = 0.5e-3;
  /// Length of the tip whose direction counts.
  double tip = 1e-3;
};

/// Watches an insertion tick by tick. Force limits apply to every model, the shape to a rod.
///
///     slack  = (length - depth) - |opening - tweezers|
///     folded = t . s < -1/2 at the tip: t its direction, s the direction of the scala
class EndDetector {
public:
  /// @param stopForce  Axial force at which the surgeon stops [N]; 0: none.
  EndDetector(const mechanics::InsertionModel& model, double stopForce) noexcept;

  /// The event of this tick, or none. O(1).
  InsertionEnd detect(const mechanics::InsertionModel& model,
                      const mechanics::InsertionState& state, bool isWithdrawing) noexcept;

  /// Adds all data that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  bool isTipFolded(const mechanics::InsertionModel& model,
                   const mechanics::InsertionState& state) const noexcept;
  bool isStalled(const Eigen::Vector3d& tip_W, double depth) noexcept;

  EndLimits limits_;
  double stopForce_;
  bool isRod_;
  std::size_t tipNodes_;        // edges that the tip's direction spans
  double sense_;                // of the angle around the modiolus: 1 counterclockwise about W's z
  Eigen::Vector3d stallTip_W_;  // where the tip last advanced
  double stallDepth_;           // the depth then [m]
};

/// Way of the tweezers to the bone around the opening [m], which they touch when the array in them
/// does; 0 at the bone and beyond.
///
/// @param base_W    Position of the tweezers [m].
/// @param inward_W  Unit: direction of their motion, within 60 degrees of the opening's axis.
double distanceToBone(const mechanics::InsertionModel& model, const Eigen::Vector3d& base_W,
                      const Eigen::Vector3d& inward_W) noexcept;

}  // namespace perilymph::haptics
