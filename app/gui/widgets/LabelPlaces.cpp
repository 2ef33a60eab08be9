// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/LabelPlaces.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double pointRadius_px = 7.0;  // of the ring about a point, which no label covers
constexpr double beside_px = 9.0;       // a nearer label needs no line
constexpr double step_px = 6.0;
constexpr int directions = 24;

bool areCrossing(const QLineF& one, const QLineF& other)
{
  return !one.isNull() && !other.isNull() &&
         one.intersects(other, nullptr) == QLineF::BoundedIntersection;
}

bool isCrossing(const QLineF& leader, const QRectF& area)
{
  if (leader.isNull() || area.isNull()) return false;
  return area.contains(leader.p1()) || area.contains(leader.p2()) ||
         areCrossing(leader, {area.topLeft(), area.topRight()}) ||
         areCrossing(leader, {area.topRight(), area.bottomRight()}) ||
         areCrossing(leader, {area.bottomRight(), area.bottomLeft()}) ||
         areCrossing(leader, {area.bottomLeft(), area.topLeft()});
}

/// A rectangle whose edge is a distance from a point, in a direction from it.
QRectF beside(const LabelledPoint& label, double distance, double angle)
{
  const QPointF aside(std::cos(angle), std::sin(angle));
  const QPointF center =
      label.at + distance * aside +
      QPointF(0.5 * label.size.width() * aside.x(), 0.5 * label.size.height() * aside.y());
  QRectF area({0.0, 0.0}, label.size);
  area.moveCenter(center);
  return area;
}

}  // namespace

QLineF leaderLine(const QPointF& point, const QRectF& label)
{
  if (label.isNull()) return {};
  const QPointF end(std::clamp(point.x(), label.left(), label.right()),
                    std::clamp(point.y(), label.top(), label.bottom()));
  const QLineF whole(point, end);
  if (whole.length() <= beside_px) return {};
  // from the ring on
  return {whole.pointAt(pointRadius_px / whole.length()), end};
}

std::vector<QRectF> placeLabels(const std::vector<LabelledPoint>& labels, const QRectF& pane,
                                const std::vector<QRectF>& taken)
{
  std::vector<QRectF> occupied = taken;
  for (const LabelledPoint& label : labels)
    occupied.emplace_back(label.at - QPointF(pointRadius_px, pointRadius_px),
                          QSizeF(2.0 * pointRadius_px, 2.0 * pointRadius_px));
  const auto isFree = [&](const QRectF& area) {
    return pane.contains(area) && std::ranges::none_of(occupied, [&](const QRectF& other) {
             return other.intersects(area);
           });
  };
  std::vector<QRectF> places;
  std::vector<QLineF> leaders;
  const auto isClear = [&](const QPointF& point, const QRectF& area) {
    const QLineF leader = leaderLine(point, area);
    return std::ranges::none_of(leaders,
                                [&](const QLineF& other) {
                                  return areCrossing(other, leader) || isCrossing(other, area);
                                }) &&
           std::ranges::none_of(places,
                                [&](const QRectF& place) { return isCrossing(leader, place); });
  };
  const double farthest = pane.width() + pane.height();
  for (const LabelledPoint& label : labels) {
    QRectF place;  // the nearest free one, and better one whose line crosses nothing
    bool isFound = false;
    for (double distance = pointRadius_px + 1.0; distance < farthest && !isFound;
         distance += step_px)
      for (int k = 0; k < directions && !isFound; ++k) {
        // first up and to the right, as in figures
        const QRectF area = beside(label, distance, 2.0 * pi * (k - 3) / directions);
        if (!isFree(area)) continue;
        isFound = isClear(label.at, area);
        if (isFound || place.isNull()) place = area;
      }
    places.push_back(place);
    leaders.push_back(leaderLine(label.at, place));
    if (!place.isNull()) occupied.push_back(place);
  }
  return places;
}

}  // namespace perilymph::gui
