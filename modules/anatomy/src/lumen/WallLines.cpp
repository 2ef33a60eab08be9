// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/WallLines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lumen/SectionWall.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

// A parabola approximates a lengthwise line up to half its radius of curvature (0.5 rad of arc).
constexpr double parabolaReach = 0.5;

}  // namespace

WallLines::WallLines(const ScalaTympani& scala, double angle)
{
  const SineCosine turn = sineCosine(angle);
  const Eigen::Vector3d outward(turn.cosine, turn.sine, 0.0);
  const Eigen::Vector3d center = scala.center_W(angle);
  constexpr double nudge = 1e-3;  // [rad]
  // at the first and the last section use the direction at a neighboring angle
  const double middle = std::clamp(angle, nudge, scala.lastAngle().si() - nudge);

  const SectionWall here(scala, angle), at(scala, middle);
  const SectionWall behind(scala, middle - nudge), ahead(scala, middle + nudge);

  for (int k = 0; k < points; ++k) {
    const double direction = 2.0 * pi * k / points;
    const SineCosine around = sineCosine(direction);
    const Eigen::Vector3d e = here.at(direction, around) - center;
    const Eigen::Vector3d before = behind.at(direction, around);
    const Eigen::Vector3d after = ahead.at(direction, around);
    const Eigen::Vector3d along = (after - before).normalized();
    Eigen::Vector3d bend =
        (after + before - 2.0 * at.at(direction, around)) / (0.25 * (after - before).squaredNorm());
    bend -= bend.dot(along) * along;
    const std::size_t place = placeOf(k);
    u_[place] = e.dot(outward);
    v_[place] = e.z();
    alongU_[place] = along.dot(outward);
    alongV_[place] = along.z();
    bendU_[place] = bend.dot(outward);
    bendV_[place] = bend.z();
    bend_[place] = bend.norm();
    reach_[place] = parabolaReach / std::max(bend_[place], 1.0);
    minRadius_ = std::min(minRadius_, std::sqrt(u_[place] * u_[place] + v_[place] * v_[place]));
    const double inSection = alongU_[place] * alongU_[place] + alongV_[place] * alongV_[place];
    minSlant_ = std::min(minSlant_, std::sqrt(1.0 - inSection));
  }
}

// Squared distance in space to a parabola with the line's tangent t and curvature c, at the arc
// length s of one Newton step, where e is the vector from the outline's point:
//
//     s = e.t / (1 - e.c),   d^2 = |e - s t - s^2 c / 2|^2
inline double WallLines::squaredDistance(std::size_t place, double u, double v) const noexcept
{
  const double eu = u - u_[place];
  const double ev = v - v_[place];
  const double along = eu * alongU_[place] + ev * alongV_[place];
  const double straightness = 1.0 - eu * bendU_[place] - ev * bendV_[place];
  const double s =
      std::min(std::max(along / std::max(straightness, 0.1), -reach_[place]), reach_[place]);
  const double sag = 0.5 * s * s * bend_[place];
  return eu * eu + ev * ev - 2.0 * s * along + s * s * straightness + sag * sag;
}

double WallLines::distance(double u, double v) const noexcept
{
  double squared[coarse];
  for (std::size_t i = 0; i < coarse; ++i) squared[i] = squaredDistance(i, u, v);
  int nearest = 0;
  double minimum = 1e9;
  for (int i = 0; i < coarse; ++i)
    if (squared[i] < minimum) {
      minimum = squared[i];
      nearest = stride * i;
    }

  // then the neighbors of the nearest
  const auto squaredTo = [&](int k) { return squaredDistance(placeOf(k), u, v); };
  const int middle = nearest;
  const auto consider = [&](int k) {
    const double found = squaredTo(k);
    if (found < minimum) {
      minimum = found;
      nearest = k;
    }
  };
  for (int k = 1; k < stride; ++k) {
    consider((middle + k) % points);
    consider((middle + points - k) % points);
  }
  const double before = squaredTo((nearest + points - 1) % points);
  const double after = squaredTo((nearest + 1) % points);
  const double bend = before - 2.0 * minimum + after;
  if (bend > 0.0) minimum -= (after - before) * (after - before) / (8.0 * bend);
  return std::sqrt(std::max(minimum, 0.0));
}

}  // namespace perilymph::anatomy
