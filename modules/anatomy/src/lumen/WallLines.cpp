// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/WallLines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "lumen/SectionWall.h"
#include "perilymph/foundation/Four.h"
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
    const Direction& direction = directionsAround<points>()[static_cast<std::size_t>(k)];
    const Eigen::Vector3d e = here.at(direction) - center;
    const Eigen::Vector3d before = behind.at(direction);
    const Eigen::Vector3d after = ahead.at(direction);
    const Eigen::Vector3d along = (after - before).normalized();
    Eigen::Vector3d bend =
        (after + before - 2.0 * at.at(direction)) / (0.25 * (after - before).squaredNorm());
    bend -= bend.dot(along) * along;
    const auto place = static_cast<std::size_t>(k + stride);
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
    slope_[place] = std::sqrt(inSection);
    minSlant_ = std::min(minSlant_, std::sqrt(1.0 - inSection));
  }
  for (Column* column : {&u_, &v_, &alongU_, &alongV_, &bendU_, &bendV_, &bend_, &reach_}) {
    std::copy_n(column->begin() + points, stride, column->begin());
    std::copy_n(column->begin() + stride, stride + 1, column->begin() + stride + points);
  }
}

namespace {

/// A point of an outline and its lengthwise line, as the columns.
template <class T>
struct Line {
  T u, v, alongU, alongV, bendU, bendV, bend, reach;
};

// Squared distance in space to a parabola with the line's tangent t and curvature c, at the arc
// length s of one Newton step, where e is the vector from the outline's point:
//
//     s = e.t / (1 - e.c),   d^2 = |e - s t - s^2 c / 2|^2
template <class T>
PERILYMPH_IN_LANES T squaredDistance(const Line<T>& line, const T& u, const T& v) noexcept
{
  const T eu = u - line.u;
  const T ev = v - line.v;
  const T along = eu * line.alongU + ev * line.alongV;
  const T straightness = 1.0 - eu * line.bendU - ev * line.bendV;
  const T s = smaller(larger(along / larger(straightness, 0.1), T(-line.reach)), line.reach);
  const T sag = 0.5 * s * s * line.bend;
  return eu * eu + ev * ev - 2.0 * s * along + s * s * straightness + sag * sag;
}

PERILYMPH_IN_LANES Four fourOf(double x) noexcept { return Four{x, x, x, x}; }

}  // namespace

template <class T>
PERILYMPH_IN_LANES T WallLines::squaredTo(std::size_t place, const T& u, const T& v) const noexcept
{
  const auto at = [place](const Column& column) PERILYMPH_KERNEL {
    const double value = column.data()[place];
    if constexpr (std::is_same_v<T, Four>)
      return fourOf(value);
    else
      return value;
  };
  const Line<T> line{at(u_),     at(v_),     at(alongU_), at(alongV_),
                     at(bendU_), at(bendV_), at(bend_),   at(reach_)};
  return squaredDistance(line, u, v);
}

PERILYMPH_IN_LANES auto WallLines::squaredBeside(std::size_t place, double u,
                                                 double v) const noexcept
{
  const auto at = [place](const Column& column) PERILYMPH_KERNEL {
    using Two [[gnu::vector_size(16)]] = double;
    const Two before = load<Two>(column.data(), place - 2);
    const Two after = load<Two>(column.data(), place + 1);
    return __builtin_shufflevector(before, after, 0, 1, 2, 3);
  };
  const Line<Four> lines{at(u_),     at(v_),     at(alongU_), at(alongV_),
                         at(bendU_), at(bendV_), at(bend_),   at(reach_)};
  return squaredDistance(lines, fourOf(u), fourOf(v));
}

PERILYMPH_IN_LANES double WallLines::refined(std::size_t place, double squared, double u,
                                             double v) const noexcept
{
  const Four beside = squaredBeside(place, u, v);
  double near[2 * stride + 1] = {0.0, beside[0], beside[1], squared, beside[2], beside[3], 0.0};
  int nearest = stride;
  for (const int k : {4, 2, 5, 1})
    if (near[k] < near[nearest]) nearest = k;
  if (nearest == 1) near[0] = squaredTo<double>(place - stride, u, v);
  if (nearest == 5) near[6] = squaredTo<double>(place + stride, u, v);
  const double minimum = near[nearest];
  const double slope = near[nearest + 1] - near[nearest - 1];
  const double bend = near[nearest - 1] - 2.0 * minimum + near[nearest + 1];
  return bend > 0.0 ? minimum - slope * slope / (8.0 * bend) : minimum;
}

double WallLines::distance(double u, double v) const noexcept
{
  double minimum = 1e9, squared = 0.0;
  std::size_t nearest = placeOf(0);
  for (int k = 0; k < coarse; ++k)
    if (const double found = squaredTo<double>(placeOf(k), u, v); found < minimum) {
      minimum = found;
      nearest = placeOf(k);
    }
  withLanes([&]() PERILYMPH_KERNEL { squared = refined(nearest, minimum, u, v); });
  return std::sqrt(std::max(squared, 0.0));
}

// With e from a line's point in the section, and its tangent t and curvature c there:
//
//     d <= |e|,   because s moves toward the line's nearest point
//     d^2 >= |e|^2 - (e.t)^2 / k     for k = 1 - e.c >= 0.1,   the minimum of the part without s^4
//     d^2 >= |e|^2 - 2 reach |e.t| + min(0, k) reach^2         else,   as |s| <= reach
//
// Within a radius of the middle each of |e|, e.t and k changes by at most the radius times 1, |t| and |c|.
PERILYMPH_IN_LANES std::size_t WallLines::candidates(double u, double v, double radius,
                                                     std::size_t* places) const noexcept
{
  double off[coarse];
  double nearest = 1e9;
  for (int k = 0; k < coarse; ++k) {
    const std::size_t place = placeOf(k);
    const double eu = u - u_.data()[place], ev = v - v_.data()[place];
    off[k] = std::sqrt(eu * eu + ev * ev);
    nearest = smaller(nearest, off[k]);
  }
  constexpr double rounding = 1.0 + 1e-9;
  const double largest = (nearest + radius) * (nearest + radius) * rounding;
  std::size_t count = 0;
  for (int k = 0; k < coarse; ++k) {
    const std::size_t place = placeOf(k);
    const double eu = u - u_.data()[place], ev = v - v_.data()[place];
    const double along = std::fabs(eu * alongU_.data()[place] + ev * alongV_.data()[place]) +
                         radius * slope_.data()[place];
    const double straightness =
        1.0 - eu * bendU_.data()[place] - ev * bendV_.data()[place] - radius * bend_.data()[place];
    const double reach = reach_.data()[place];
    const double least = larger(off[k] - radius, 0.0);
    const double shift = straightness >= 0.1
                             ? along * along / straightness
                             : 2.0 * reach * along - smaller(straightness, 0.0) * reach * reach;
    places[count] = place;
    count += least * least - shift <= largest ? 1 : 0;
  }
  return count;
}

PERILYMPH_IN_LANES void WallLines::distancesInLanes(std::span<const double> u,
                                                    std::span<const double> v,
                                                    double* to) const noexcept
{
  constexpr std::size_t high = 4, wide = 8;
  for (std::size_t i = 0; i < u.size(); i += high)
    for (std::size_t j = 0; j < v.size(); j += wide) {
      const std::size_t endOfU = i + high < u.size() ? i + high : u.size();
      const std::size_t endOfV = j + wide < v.size() ? j + wide : v.size();
      const double halfU = 0.5 * (u[endOfU - 1] - u[i]), halfV = 0.5 * (v[endOfV - 1] - v[j]);
      std::size_t places[coarse + 1];
      const std::size_t count =
          candidates(u[i] + halfU, v[j] + halfV, std::sqrt(halfU * halfU + halfV * halfV), places);
      for (std::size_t row = i; row < endOfU; ++row)
        for (std::size_t first = j; first < endOfV; first += 4) {
          const std::size_t lanes = endOfV - first < 4 ? endOfV - first : 4;
          double at[4];
          for (std::size_t lane = 0; lane < 4; ++lane)
            at[lane] = v[first + (lane < lanes ? lane : 0)];
          const Four ofV = load<Four>(at, 0), ofU = fourOf(u[row]);
          Four minima = fourOf(1e9), nearest{};
          for (std::size_t k = 0; k < count; ++k) {
            const Four found = squaredTo<Four>(places[k], ofU, ofV);
            const auto isLess = found < minima;  // the first of equals
            minima = oneOf(isLess, found, minima);
            nearest = oneOf(isLess, fourOf(static_cast<double>(places[k])), nearest);
          }
          for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double squared =
                refined(static_cast<std::size_t>(nearest[lane]), minima[lane], u[row], at[lane]);
            to[row * v.size() + first + lane] = std::sqrt(larger(squared, 0.0));
          }
        }
    }
}

void WallLines::distances(std::span<const double> u, std::span<const double> v,
                          double* to) const noexcept
{
  withLanes([&]() PERILYMPH_KERNEL { distancesInLanes(u, v, to); });
}

}  // namespace perilymph::anatomy
