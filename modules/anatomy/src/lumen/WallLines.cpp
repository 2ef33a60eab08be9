// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/WallLines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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
template <class T>
PERILYMPH_IN_LANES T WallLines::squaredTo(std::size_t place, double u, double v) const noexcept
{
  const T eu = u - load<T>(u_.data(), place);
  const T ev = v - load<T>(v_.data(), place);
  const T along = eu * load<T>(alongU_.data(), place) + ev * load<T>(alongV_.data(), place);
  const T straightness =
      1.0 - eu * load<T>(bendU_.data(), place) - ev * load<T>(bendV_.data(), place);
  const T reach = load<T>(reach_.data(), place);
  const T s = smaller(larger(along / larger(straightness, 0.1), -reach), reach);
  const T sag = 0.5 * s * s * load<T>(bend_.data(), place);
  return eu * eu + ev * ev - 2.0 * s * along + s * s * straightness + sag * sag;
}

PERILYMPH_IN_LANES double WallLines::squaredDistance(double u, double v) const noexcept
{
  static_assert(stride == 3 && coarse % 4 == 0);
  double squared[coarse];
  Four minima = Four{} + 1e9, places{};
  for (std::size_t i = 0; i < coarse; i += 4) {
    const Four found = squaredTo<Four>(i, u, v);
    store(found, squared, i);
    const auto isLess = found < minima;
    minima = oneOf(isLess, found, minima);
    places = oneOf(isLess, Four{0.0, 1.0, 2.0, 3.0} + static_cast<double>(i), places);
  }
  double minimum = 1e9, place = 0.0;  // the first of equals
  for (int lane = 0; lane < 4; ++lane)
    if (minima[lane] < minimum || (minima[lane] == minimum && places[lane] < place)) {
      minimum = minima[lane];
      place = places[lane];
    }

  // then the neighbors of the nearest
  const auto middle = static_cast<std::size_t>(place);
  const std::size_t before = (middle + coarse - 1) % coarse;
  const double near[] = {squared[before],
                         squaredTo<double>(coarse + before, u, v),
                         squaredTo<double>(2 * coarse + before, u, v),
                         minimum,
                         squaredTo<double>(coarse + middle, u, v),
                         squaredTo<double>(2 * coarse + middle, u, v),
                         squared[(middle + 1) % coarse]};
  int nearest = 3;
  for (const int k : {4, 2, 5, 1})
    if (near[k] < near[nearest]) nearest = k;
  minimum = near[nearest];
  const double slope = near[nearest + 1] - near[nearest - 1];
  const double bend = near[nearest - 1] - 2.0 * minimum + near[nearest + 1];
  return bend > 0.0 ? minimum - slope * slope / (8.0 * bend) : minimum;
}

double WallLines::distance(double u, double v) const noexcept
{
  double squared = 0.0;
  withLanes([&]() PERILYMPH_KERNEL { squared = squaredDistance(u, v); });
  return std::sqrt(std::max(squared, 0.0));
}

}  // namespace perilymph::anatomy
