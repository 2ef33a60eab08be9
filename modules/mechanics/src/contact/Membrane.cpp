// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/Membrane.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

constexpr double sectionStep = 2.0 * pi / 180.0;  // [rad]
constexpr double fading = 5.0 * pi / 180.0;       // [rad]

/// Smooth step from 0 to 1 with its derivative.
struct Ramp {
  double value, slope;
  explicit Ramp(double q)
  {
    const double x = std::clamp(q, 0.0, 1.0);
    value = x * x * (3.0 - 2.0 * x);
    slope = 6.0 * x * (1.0 - x);
  }
};

/// A table over the angle as a quadratic B-spline, which has a continuous derivative.
struct Entry {
  double value, slope;
  Entry(const std::vector<double>& table, double index)
  {
    const double last = static_cast<double>(table.size() - 2);
    const double place = std::clamp(index, 1.0, last);
    const auto middle = static_cast<std::size_t>(std::floor(place + 0.5));
    const double x = place - static_cast<double>(middle);  // -0.5 to 0.5
    const double a = table[middle - 1], b = table[middle], c = table[middle + 1];
    value = 0.5 * (0.5 - x) * (0.5 - x) * a + (0.75 - x * x) * b + 0.5 * (0.5 + x) * (0.5 + x) * c;
    slope = (x - 0.5) * a - 2.0 * x * b + (x + 0.5) * c;
  }
};

}  // namespace

MembranePlace::MembranePlace(const anatomy::ScalaTympani& scala)
    : lastAngle_(scala.lastAngle().si())
{
  const int sections = std::max(static_cast<int>(std::ceil(lastAngle_ / sectionStep)) + 1, 3);
  perSection_ = (sections - 1) / lastAngle_;
  const auto radiusAt = [&](double angle, double across) {
    const Eigen::Vector3d edge = scala.membrane_W(angle, across);
    return std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
  };
  for (int i = 0; i < sections; ++i) {
    inner_.push_back(radiusAt(i / perSection_, 0.0));
    outer_.push_back(radiusAt(i / perSection_, 1.0));
  }
}

MembraneFraction MembranePlace::fractionAt(const Eigen::Vector3d& at_W, double radius,
                                           const anatomy::LumenTrack& track,
                                           const Eigen::Vector3d& normal_W) const noexcept
{
  const Ramp roof((-normal_W.z() - 0.2) / 0.5);
  if (track.inLeadIn || !(roof.value > 0.0)) return {};
  const Eigen::Vector3d outward_W(track.direction[0], track.direction[1], 0.0);
  const Eigen::Vector3d forward_W(-track.direction[1], track.direction[0], 0.0);
  const double r = std::max(at_W.dot(outward_W), 1e-5);
  const Entry inner(inner_, track.angle * perSection_);
  const Entry outer(outer_, track.angle * perSection_);
  // the footprint, half a radius to either side: the part beyond the inner edge minus that beyond
  // the outer
  const double inverseFootprint = 1.0 / radius;
  const Ramp pastInner(0.5 + (r - inner.value) * inverseFootprint);
  const Ramp pastOuter(0.5 + (r - outer.value) * inverseFootprint);
  const double across = pastInner.value - pastOuter.value;
  if (!(across > 0.0)) return {};

  const Ramp begin(track.angle / fading), end((lastAngle_ - track.angle) / fading);
  const double present = roof.value * begin.value * end.value;
  const double outwardRate = (pastInner.slope - pastOuter.slope) * inverseFootprint;
  const double forwardRate = -(pastInner.slope * inner.slope - pastOuter.slope * outer.slope) *
                             inverseFootprint * perSection_ / r;
  const double presentRate =
      roof.value * (begin.slope * end.value - begin.value * end.slope) / (fading * r);
  return {present * across, present * (outwardRate * outward_W + forwardRate * forward_W) +
                                (across * presentRate) * forward_W};
}

}  // namespace perilymph::mechanics
