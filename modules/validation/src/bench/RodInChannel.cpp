// SPDX-License-Identifier: BSD-3-Clause
#include "RodInChannel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "perilymph/foundation/Math.h"

namespace perilymph::validation {

namespace {

constexpr double step = 0.05e-3;
constexpr double taperLength = 15e-3;

}  // namespace

double SpiralChannel::curvatureAt(double length) const noexcept
{
  const double x = std::clamp((length - start) / onset + 0.5, 0.0, 1.0);
  const double radius = radiusAt10 * (1.0 - tightening * (length - 10e-3));
  return x * x * (3.0 - 2.0 * x) / radius;
}

ChannelForce::ChannelForce(const SpiralChannel& channel, double friction, double deepest)
    : friction_(friction)
{
  const auto steps = static_cast<std::size_t>(std::lround(deepest / step));
  double angle = 0.0;
  for (std::size_t i = 0; i <= steps; ++i) {
    curvature_.push_back(channel.curvatureAt(step * static_cast<double>(i)));
    if (i > 0) angle += 0.5 * step * (curvature_[i] + curvature_[i - 1]);
    gain_.push_back(exponential(friction * angle));
  }
}

double ChannelForce::at(double depth, double growth, double tipCotangent) const
{
  const auto tip = static_cast<std::size_t>(std::lround(depth / step));
  const auto moment = [&](std::size_t i) {
    return (1.0 + growth * step * static_cast<double>(tip - i) / taperLength) * curvature_[i];
  };
  double force =
      gain_[tip] * curvature_[tip] * curvature_[tip] * (1.0 + 0.5 * friction_ * tipCotangent);
  for (std::size_t i = 0; i < tip; ++i)
    force -= 0.25 * (gain_[i] + gain_[i + 1]) * (curvature_[i] + curvature_[i + 1]) *
             (moment(i + 1) - moment(i));
  return force;
}

}  // namespace perilymph::validation
