// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A value at equally spaced places: force over depth, force over the angle.

#include <algorithm>
#include <cmath>
#include <vector>

#include "perilymph/analysis/InsertionRun.h"

namespace perilymph::analysis {

/// Finds the value at each multiple of the spacing that a place passes for the first time, linear
/// between ticks.
class FirstPassages {
public:
  /// @param spacing  In the unit of the places; 0: no points.
  explicit FirstPassages(double spacing) : spacing_(spacing) {}

  /// @param take  Is called with place and value of each new point, in ascending order.
  template <class Take>
  void add(double place, double value, Take&& take)
  {
    if (!(spacing_ > 0.0)) return;
    if (hasBegun_ && place > place_) {
      for (; static_cast<double>(next_) * spacing_ <= place; ++next_) {
        const double passed = static_cast<double>(next_) * spacing_;
        const double fraction = (passed - place_) / (place - place_);
        take(passed, value_ + fraction * (value - value_));
      }
    }
    if (!hasBegun_) next_ = static_cast<long>(std::ceil(std::max(place, 0.0) / spacing_));
    if (hasBegun_ && place < place_) return;  // the value at the first passage counts
    hasBegun_ = true;
    place_ = place;
    value_ = value;
  }

private:
  double spacing_;
  bool hasBegun_ = false;
  long next_ = 0;
  double place_ = 0.0, value_ = 0.0;
};

/// Adds the force at each multiple of the spacing that the tip passes for the first time.
class ProfilePoints {
public:
  /// @param spacing  0: no points.
  explicit ProfilePoints(Length spacing) : passages_(spacing.si()) {}

  /// @param depth  [m]
  /// @param force  [N]
  void add(std::vector<DepthForce>& profile, double depth, double force)
  {
    passages_.add(depth, force, [&profile](double place, double value) {
      profile.push_back({meters(place), newtons(value)});
    });
  }

private:
  FirstPassages passages_;
};

}  // namespace perilymph::analysis
