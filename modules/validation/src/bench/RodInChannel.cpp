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

ChannelForce::Parts ChannelForce::at(double depth) const
{
  const auto tip = static_cast<std::size_t>(std::lround(depth / step));
  Parts parts;
  parts.tip = gain_[tip] * curvature_[tip] * curvature_[tip];
  parts.tipFriction = 0.5 * friction_ * parts.tip;
  // the moment falls by k' EI(0), and by r times the rest
  double lever = step * static_cast<double>(tip) / taperLength * curvature_[0];
  for (std::size_t i = 0; i < tip; ++i) {
    const double across = 0.25 * (gain_[i] + gain_[i + 1]) * (curvature_[i] + curvature_[i + 1]);
    const double next = step * static_cast<double>(tip - i - 1) / taperLength * curvature_[i + 1];
    parts.uniform -= across * (curvature_[i + 1] - curvature_[i]);
    parts.growing -= across * (next - lever);
    lever = next;
  }
  return parts;
}

}  // namespace perilymph::validation
