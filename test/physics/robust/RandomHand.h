// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A hand without skill: it pushes, pulls, turns and trembles at random, the same way for the same
// seed.

#include <Eigen/Core>
#include <cstdint>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::test {

/// Numbers that are the same on every machine (splitmix64, Vigna).
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
  /// Even, low to high.
  double within(double low, double high);

private:
  std::uint64_t state_;
};

/// What becomes of the stylet.
enum class StyletUse {
  stays,   ///< It stays in.
  pulled,  ///< It is pulled out at a depth and a speed drawn by lot.
  held,    ///< Advance off-stylet: it is held still at the array's hold depth.
  out,     ///< It is out from the first tick on.
};

/// How wild the hand is.
struct HandLimits {
  double fastest = 0.2;     ///< Maximum speed of pushing and pulling [m/s].
  double lateral = 0.5e-3;  ///< Beside the axis of the opening [m].
  double tremor = 0.1e-3;   ///< Amplitude at 8 Hz [m] (Muerbe 2001: 8.1 Hz).
  double tilt = 0.17;       ///< Tilt of the axis about the opening [rad].
  double roll = 1.0;        ///< About the axis [rad].
  double before = 2e-3;     ///< How far the tip may be drawn out of the opening [m].
};

/// Moves the base of an array about its opening.
class RandomHand {
public:
  RandomHand(const mechanics::InsertionModel& model, HandLimits limits, StyletUse stylet,
             std::uint64_t seed);

  /// The drive of the next tick. `coupling` and its numbers are left to the caller.
  mechanics::Drive next(const mechanics::InsertionState& state);

private:
  /// A value that wanders between its ends at changing speeds.
  struct Wanderer {
    double value = 0.0, low = 0.0, high = 0.0, fastest = 0.0;
    double speed = 0.0;
    int left = 0;  // ticks until it changes its mind
  };
  void wander(Wanderer& wanderer);
  double withdrawal(const mechanics::InsertionState& state);

  const mechanics::InsertionModel& model_;
  RandomNumbers random_;
  HandLimits limits_;
  StyletUse stylet_;
  double pullDepth_, pullSpeed_;
  double tremorPhase_[3];
  Wanderer advance_, beside_[2], tilt_[2], roll_;
  double withdrawal_ = 0.0;
  double time_ = 0.0;
  Eigen::Vector3d last_W_;
};

}  // namespace perilymph::test
