// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/ForceBands.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/setup/PlannedFriction.h"
#include "perilymph/planning/ForceCourse.h"

namespace perilymph::gui {

namespace {

struct BandStyle {
  figures::Ink ink;
  double dash;
};
constexpr BandStyle bandStyles[] = {{figures::ink::blue, 0.0},
                                    {figures::ink::vermilion, 6.0},
                                    {figures::ink::green, 3.0},
                                    {figures::ink::purple, 1.5}};

std::string figureText(const char* text)
{
  return QCoreApplication::translate("perilymph::gui", text).toStdString();
}

}  // namespace

figures::Figure forceBands(const planning::Plan& plan, const std::vector<std::size_t>& arrays)
{
  figures::Figure figure;
  figure.title = figureText(QT_TRANSLATE_NOOP("perilymph::gui", "Insertion force over depth"));
  double top_mN = 10.0, deepest_mm = 1.0;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const planning::ArrayPlan& array = plan.arrays[arrays[i]];
    const BandStyle& style = bandStyles[i % std::size(bandStyles)];
    planning::addForceCourse(
        figure, array,
        {array.name, {}, {}, {}, figureText(QT_TRANSLATE_NOOP("perilymph::gui", "%1 of %2"))},
        style.ink, style.dash);
    for (const planning::ForceBand& each : array.force) {
      top_mN = std::max(top_mN, each.force_mN.high);
      deepest_mm = std::max(deepest_mm, each.depth_mm);
    }
  }
  figure.x = figures::axisOver(
      figureText(QT_TRANSLATE_NOOP("perilymph::gui", "insertion depth, mm")), 0.0, deepest_mm);
  figure.y = figures::axisOver(
      figureText(QT_TRANSLATE_NOOP("perilymph::gui", "axial insertion force, mN")), 0.0, top_mN);
  figure.notes.push_back(
      QCoreApplication::translate("perilymph::gui",
                                  "Lines: median; areas: %1. Paler and dotted where simulations "
                                  "have ended (rings), with the number that came that deep.")
          .arg(bandsHold(plan))
          .toStdString());
  return figure;
}

}  // namespace perilymph::gui
