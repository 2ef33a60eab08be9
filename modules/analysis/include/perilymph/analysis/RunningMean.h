// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force at rest: a mean over the last moments.

#include <deque>

#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// Rounding of a time that is a sum of time steps [s].
inline constexpr double timeRounding = 1e-9;

/// Mean of a value over the last moments, tick by tick, in order.
class RunningMean {
public:
  explicit RunningMean(Duration window) : window_(window.si()) {}

  /// @param time  [s], later than those before.
  void add(double time, double value)
  {
    last_.push_back({time, value});
    sum_ += value;
    while (last_.size() > 1 && last_.front().time <= time - window_ + timeRounding) {
      sum_ -= last_.front().value;
      last_.pop_front();
    }
  }

  /// 0 without a value.
  double mean() const { return last_.empty() ? 0.0 : sum_ / static_cast<double>(last_.size()); }

private:
  struct Timed {
    double time, value;
  };
  double window_;
  std::deque<Timed> last_;  ///< The values within the window.
  double sum_ = 0.0;        ///< The sum of these values.
};

}  // namespace perilymph::analysis
