// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Crossing.h"

#include <algorithm>
#include <cmath>

#include "lanes/Lanes.h"

namespace perilymph::mechanics {
namespace {

void fill(Crossing& crossing, const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
          const double (&rate)[3]) noexcept
{
  const Eigen::Vector3d* at_W = x.data() + crossing.first;
  const double* fromTip = model.fromTip.data() + crossing.first;
  const double* radius = model.radius.data() + crossing.first;
  Eigen::Vector3d sum_W = Eigen::Vector3d::Zero(), along_W = sum_W;
  double length = 0.0, thick = 0.0, thicker = 0.0;
  const auto add = [&](std::size_t k) {
    sum_W += crossing.weight[k] * at_W[k];
    along_W += rate[k] * at_W[k];
    length += crossing.weight[k] * fromTip[k];
    thick += crossing.weight[k] * radius[k];
    thicker += rate[k] * radius[k];
  };
  add(0), add(1);
  if (crossing.count == 3) add(2);
  crossing.at_W = sum_W;
  crossing.along_W = along_W;
  crossing.fromTip = length;
  crossing.radius = thick;
  crossing.radiusRate = thicker;
}

/// Intersection between the midpoints of the edges before and after node i.
Crossing crossingAt(const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
                    std::size_t i, double before, double here, double after) noexcept
{
  // A l^2 + B l + C = 0
  const double A = 0.5 * (before - 2.0 * here + after);
  const double B = here - before;
  const double C = 0.5 * (before + here);
  const double root = std::sqrt(std::max(B * B - 4.0 * A * C, 0.0)) - B;
  const double l = root > 0.0 ? std::clamp(2.0 * C / root, 0.0, 1.0) : 0.0;
  Crossing crossing;
  crossing.first = i - 1;
  crossing.count = 3;
  crossing.weight[0] = 0.5 * (1.0 - l) * (1.0 - l);
  crossing.weight[1] = 0.5 + l * (1.0 - l);
  crossing.weight[2] = 0.5 * l * l;
  fill(crossing, model, x, {l - 1.0, 1.0 - 2.0 * l, l});
  return crossing;
}

/// Intersection on the straight half edge behind the tip.
Crossing crossingAtTip(const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
                       double before, double here) noexcept
{
  const double fraction = before / (before - here);
  Crossing crossing;
  crossing.first = x.size() - 2;
  crossing.count = 2;
  crossing.weight[0] = 1.0 - fraction;
  crossing.weight[1] = fraction;
  fill(crossing, model, x, {-1.0, 1.0, 0.0});
  return crossing;
}

}  // namespace

Crossing crossingOf(const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
                    const std::vector<double>& height, double fromTip) noexcept
{
  Crossing nearest;
  const std::size_t tip = x.size() - 1;
  if (height[0] + height[1] < 0.0 || !(height[tip] < 0.0)) return nearest;
  const auto compare = [&](const Crossing& crossing) {
    if (nearest.count == 0 ||
        std::fabs(crossing.fromTip - fromTip) < std::fabs(nearest.fromTip - fromTip))
      nearest = crossing;
  };
  const auto isBetween = [&height](std::size_t i) {
    return height[i - 1] + height[i] >= 0.0 && height[i] + height[i + 1] < 0.0;
  };
  inLanes(1, tip, [&](auto lane, std::size_t first) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T here = load<T>(height, first);
    const auto wasAbove = load<T>(height, first - 1) + here >= 0.0;
    const auto isBelow = here + load<T>(height, first + 1) < 0.0;
    if (!inAny(wasAbove & isBelow)) return;
    for (std::size_t i = first; i < first + sizeof(T) / sizeof(double); ++i)
      if (isBetween(i)) compare(crossingAt(model, x, i, height[i - 1], height[i], height[i + 1]));
  });
  if (height[tip - 1] + height[tip] >= 0.0)
    compare(crossingAtTip(model, x, height[tip - 1], height[tip]));
  return nearest;
}

Crossing crossingBehind(const InsertionModel& model, const std::vector<Eigen::Vector3d>& x,
                        const std::vector<double>& height, double plane,
                        const Crossing& outer) noexcept
{
  const std::size_t tip = x.size() - 1;
  std::size_t i = std::max<std::size_t>(outer.first, 1);
  double before = height[i - 1] - plane;
  double here = height[i] - plane;
  if (before + here < 0.0 || !(height[tip] - plane < 0.0)) return Crossing();
  for (; i < tip; ++i) {
    const double after = height[i + 1] - plane;
    if (here + after < 0.0) return crossingAt(model, x, i, before, here, after);
    before = here;
    here = after;
  }
  return crossingAtTip(model, x, before, here);
}

}  // namespace perilymph::mechanics
