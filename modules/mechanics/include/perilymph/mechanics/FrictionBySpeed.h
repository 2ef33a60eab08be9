// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Kinetic friction as a tabulated function of speed.

#include <array>
#include <cstddef>
#include <vector>

#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// Coefficient of kinetic friction by sliding speed: interpolates the given points with monotone
/// cubics (slopes of Fritsch and Butland 1984), so that no extremum appears that was not measured.
/// Constant below the first and above the last speed.
class FrictionBySpeed {
public:
  static constexpr std::size_t maxPoints = 8;

  /// No points: the coefficient follows from the two coefficients of FrictionLaw.
  FrictionBySpeed() = default;
  /// @throws std::invalid_argument with a message unless there are 1 to 8 points with strictly
  /// increasing speeds of 0 or more and coefficients from 0 to 2.
  FrictionBySpeed(const std::vector<Speed>& speeds, const std::vector<double>& coefficients);

  bool isEmpty() const noexcept { return points_ == 0; }
  /// Coefficient at a speed of 0 or more [m/s]; requires points. Real-time safe.
  double at(double speed) const noexcept;
  /// Derivative of the coefficient by the speed [s/m]; requires points. Real-time safe.
  double slopeAt(double speed) const noexcept;
  /// Minimum and maximum coefficient; require points.
  double minimum() const noexcept;
  double maximum() const noexcept;
  /// All coefficients times a factor of 0 or more, reduced where one would exceed the maximum of 2.
  FrictionBySpeed scaled(double factor) const noexcept;
  void addTo(Hash& hash) const noexcept;

private:
  std::size_t points_ = 0;
  std::array<double, maxPoints> speed_{};        // [m/s]
  std::array<double, maxPoints> coefficient_{};  // at each speed
  std::array<double, maxPoints> slope_{};        // of the coefficient at each speed [s/m]
};

}  // namespace perilymph::mechanics
