// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/WallLines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

  for (int k = 0; k < points; ++k) {
    const double direction = 2.0 * pi * k / points;
    const Eigen::Vector3d e = scala.wall_W(angle, direction) - center;
    const Eigen::Vector3d before = scala.wall_W(middle - nudge, direction);
    const Eigen::Vector3d after = scala.wall_W(middle + nudge, direction);
    const Eigen::Vector3d along = (after - before).normalized();
    Eigen::Vector3d bend = (after + before - 2.0 * scala.wall_W(middle, direction)) /
                           (0.25 * (after - before).squaredNorm());
    bend -= bend.dot(along) * along;
    const Line line{e.dot(outward),    e.z(),    along.dot(outward), along.z(),
                    bend.dot(outward), bend.z(), bend.norm()};
    minRadius_ = std::min(minRadius_, std::sqrt(line.u * line.u + line.v * line.v));
    const double inSection = line.alongU * line.alongU + line.alongV * line.alongV;
    minSlant_ = std::min(minSlant_, std::sqrt(1.0 - inSection));
    lines_[static_cast<std::size_t>(k)] = line;
  }
}

// Squared distance in space to a parabola with the line's tangent t and curvature c, at the arc
// length s of one Newton step, where e is the vector from the outline's point:
//
//     s = e.t / (1 - e.c),   d^2 = |e - s t - s^2 c / 2|^2
double WallLines::Line::squaredDistance(double atU, double atV) const noexcept
{
  const double eu = atU - u;
  const double ev = atV - v;
  const double along = eu * alongU + ev * alongV;
  const double straightness = 1.0 - eu * bendU - ev * bendV;
  const double reach = parabolaReach / std::max(bend, 1.0);
  const double s = std::clamp(along / std::max(straightness, 0.1), -reach, reach);
  const double sag = 0.5 * s * s * bend;
  return eu * eu + ev * ev - 2.0 * s * along + s * s * straightness + sag * sag;
}

double WallLines::distance(double u, double v) const noexcept
{
  const auto squaredTo = [&](int k) {
    return lines_[static_cast<std::size_t>(k)].squaredDistance(u, v);
  };
  // every third point first, then the neighbors of the nearest
  constexpr int stride = 3;
  int nearest = 0;
  double minimum = 1e9;
  const auto consider = [&](int k) {
    const double squared = squaredTo(k);
    if (squared < minimum) {
      minimum = squared;
      nearest = k;
    }
  };
  for (int k = 0; k < points; k += stride) consider(k);
  const int coarse = nearest;
  for (int k = 1; k < stride; ++k) {
    consider((coarse + k) % points);
    consider((coarse + points - k) % points);
  }
  const double before = squaredTo((nearest + points - 1) % points);
  const double after = squaredTo((nearest + 1) % points);
  const double bend = before - 2.0 * minimum + after;
  if (bend > 0.0) minimum -= (after - before) * (after - before) / (8.0 * bend);
  return std::sqrt(std::max(minimum, 0.0));
}

}  // namespace perilymph::anatomy
