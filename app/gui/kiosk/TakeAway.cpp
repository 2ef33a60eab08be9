// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/TakeAway.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

QString translated(const char* text) { return QCoreApplication::translate("TakeAway", text); }

double forceAt(const std::vector<analysis::CurvePoint>& curve, double travel)
{
  const auto after = std::lower_bound(
      curve.begin(), curve.end(), travel,
      [](const analysis::CurvePoint& point, double place) { return point.travel < place; });
  if (after == curve.end()) return curve.back().force;
  if (after == curve.begin()) return after->force;
  const analysis::CurvePoint &low = *(after - 1), &high = *after;
  const double fraction = (travel - low.travel) / (high.travel - low.travel);
  return low.force + fraction * (high.force - low.force);
}

}  // namespace

std::vector<std::pair<Length, Force>> takeAwayCurve(const std::vector<analysis::CurvePoint>& curve,
                                                    Length startInside)
{
  std::vector<std::pair<Length, Force>> points;
  if (curve.empty()) return points;
  const double last = curve.back().travel;
  for (int i = 1; i <= takeAwayPoints; ++i) {
    const double travel = last * i / takeAwayPoints;
    points.emplace_back(startInside + meters(travel), newtons(forceAt(curve, travel)));
  }
  return points;
}

QString takeAwayText(const TakeAway& taken)
{
  const auto millimeters = [](Length length) { return numberText(inMillimeters(length), 1); };
  const auto millinewtons = [](Force force) { return numberText(inMillinewtons(force), 0); };
  QStringList lines;
  lines << translated(QT_TRANSLATE_NOOP("TakeAway", "Cochlear implant insertion, simulated"))
        << translated(QT_TRANSLATE_NOOP("TakeAway", "Array: %1")).arg(taken.array)
        << translated(QT_TRANSLATE_NOOP("TakeAway", "Depth: %1 mm")).arg(millimeters(taken.depth));
  const QString peak = millinewtons(taken.peak);
  lines << (taken.level ? translated(QT_TRANSLATE_NOOP("TakeAway", "Peak force: %1 mN (%2)"))
                              .arg(peak, wordOf(*taken.level))
                        : translated(QT_TRANSLATE_NOOP("TakeAway", "Peak force: %1 mN")).arg(peak));
  if (taken.rank > 0)
    lines << translated(QT_TRANSLATE_NOOP("TakeAway", "Rank today: %1 of %2"))
                 .arg(taken.rank)
                 .arg(taken.insertions);
  lines << translated(QT_TRANSLATE_NOOP("TakeAway", "Depth in mm: force in mN"));
  for (const auto& [depth, force] : taken.curve)
    lines << millimeters(depth) + QStringLiteral(": ") + millinewtons(force);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace perilymph::gui
