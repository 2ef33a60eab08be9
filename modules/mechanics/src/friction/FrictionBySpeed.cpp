// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/FrictionBySpeed.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace perilymph::mechanics {

FrictionBySpeed::FrictionBySpeed(const std::vector<Speed>& speeds,
                                 const std::vector<double>& coefficients)
    : points_(speeds.size())
{
  if (points_ < 1 || points_ > maxPoints || coefficients.size() != points_)
    throw std::invalid_argument("Friction by speed has " + std::to_string(speeds.size()) +
                                " speeds and " + std::to_string(coefficients.size()) +
                                " coefficients; it must have as many of both, 1 to " +
                                std::to_string(maxPoints) + ".");
  for (std::size_t i = 0; i < points_; ++i) {
    speed_[i] = speeds[i].si();
    coefficient_[i] = coefficients[i];
    const bool grows = i == 0 ? speed_[0] >= 0.0 : speed_[i] > speed_[i - 1];
    if (!grows)
      throw std::invalid_argument(
          "Friction by speed has the speed " + std::to_string(inMillimetersPerSecond(speeds[i])) +
          " mm/s as number " + std::to_string(i + 1) + "; speeds must be 0 or more and grow.");
    if (!(coefficient_[i] >= 0.0 && coefficient_[i] <= 2.0))
      throw std::invalid_argument("Friction by speed has the coefficient " +
                                  std::to_string(coefficient_[i]) + " as number " +
                                  std::to_string(i + 1) + "; it must be 0 to 2.");
  }

  // Slopes: 0 at extrema and at both ends, else a weighted harmonic mean of the adjacent secants.
  for (std::size_t i = 1; i + 1 < points_; ++i) {
    const double before = speed_[i] - speed_[i - 1], after = speed_[i + 1] - speed_[i];
    const double rise = (coefficient_[i] - coefficient_[i - 1]) / before;
    const double next = (coefficient_[i + 1] - coefficient_[i]) / after;
    if (rise * next <= 0.0) continue;
    const double weight = (before + 2.0 * after) / (3.0 * (before + after));
    slope_[i] = rise * next / (weight * next + (1.0 - weight) * rise);
  }
}

double FrictionBySpeed::at(double speed) const noexcept
{
  if (speed <= speed_[0]) return coefficient_[0];
  for (std::size_t i = 1; i < points_; ++i) {
    if (speed > speed_[i]) continue;
    const double width = speed_[i] - speed_[i - 1];
    const double x = (speed - speed_[i - 1]) / width;
    const double y = 1.0 - x;
    return y * y * ((1.0 + 2.0 * x) * coefficient_[i - 1] + x * width * slope_[i - 1]) +
           x * x * ((1.0 + 2.0 * y) * coefficient_[i] - y * width * slope_[i]);
  }
  return coefficient_[points_ - 1];
}

double FrictionBySpeed::slopeAt(double speed) const noexcept
{
  if (speed <= speed_[0]) return 0.0;
  for (std::size_t i = 1; i < points_; ++i) {
    if (speed > speed_[i]) continue;
    const double width = speed_[i] - speed_[i - 1];
    const double x = (speed - speed_[i - 1]) / width;
    const double y = 1.0 - x;
    return 6.0 * x * y * (coefficient_[i] - coefficient_[i - 1]) / width +
           y * (y - 2.0 * x) * slope_[i - 1] + x * (x - 2.0 * y) * slope_[i];
  }
  return 0.0;
}

double FrictionBySpeed::minimum() const noexcept
{
  double value = coefficient_[0];
  for (std::size_t i = 1; i < points_; ++i) value = std::min(value, coefficient_[i]);
  return value;
}

double FrictionBySpeed::maximum() const noexcept
{
  double value = coefficient_[0];
  for (std::size_t i = 1; i < points_; ++i) value = std::max(value, coefficient_[i]);
  return value;
}

FrictionBySpeed FrictionBySpeed::scaled(double factor) const noexcept
{
  FrictionBySpeed other = *this;
  if (isEmpty()) return other;
  const double allowed = std::min(factor, 2.0 / std::max(maximum(), 1e-9));
  for (std::size_t i = 0; i < points_; ++i) {
    other.coefficient_[i] *= allowed;
    other.slope_[i] *= allowed;
  }
  return other;
}

void FrictionBySpeed::addTo(Hash& hash) const noexcept
{
  for (std::size_t i = 0; i < points_; ++i) {
    hash.add(speed_[i]);
    hash.add(coefficient_[i]);
  }
}

}  // namespace perilymph::mechanics
