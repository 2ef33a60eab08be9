// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ScalaProjection.h"

#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double entryDirection = 0.68 * pi;  // of a right ear's opening: to the upper left

}  // namespace

ScalaProjection::ScalaProjection(const anatomy::ScalaTympani& scala, anatomy::Side side)
    : mirror_(side == anatomy::Side::left ? -1.0 : 1.0)
{
  const Eigen::Vector3d out_W = scala.entry().out_W;
  const double wanted = side == anatomy::Side::left ? pi - entryDirection : entryDirection;
  const double turn = wanted - std::atan2(mirror_ * out_W.y(), out_W.x());
  cosine_ = std::cos(turn);
  sine_ = std::sin(turn);
}

QPointF ScalaProjection::at(double x, double y) const
{
  const double px = 1e3 * x, py = 1e3 * mirror_ * y;
  return {cosine_ * px - sine_ * py, -(sine_ * px + cosine_ * py)};
}

QPointF ScalaProjection::polar(double angle, double radius_mm) const
{
  return at(1e-3 * radius_mm * std::cos(angle), 1e-3 * radius_mm * std::sin(angle));
}

}  // namespace perilymph::gui
