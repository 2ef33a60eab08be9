// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/ForceBands.h"

#include <QCoreApplication>
#include <algorithm>

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

figures::Figure forceBands(const std::vector<const planning::ArrayPlan*>& arrays)
{
  figures::Figure figure;
  figure.title = figureText(QT_TRANSLATE_NOOP("perilymph::gui", "Insertion force over depth"));
  double top_mN = 10.0, deepest_mm = 1.0;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const BandStyle& style = bandStyles[i % std::size(bandStyles)];
    figures::FigureBand band{{}, {}, {}, {}, figures::ink::tint(style.ink, 0.15)};
    figures::FigureCurve median{arrays[i]->name, {}, {}, style.ink, 1.5, style.dash};
    for (const planning::ForceBand& each : arrays[i]->force) {
      band.x.push_back(each.depth_mm);
      band.low.push_back(each.force_mN.low);
      band.high.push_back(each.force_mN.high);
      median.x.push_back(each.depth_mm);
      median.y.push_back(each.force_mN.median);
      top_mN = std::max(top_mN, each.force_mN.high);
      deepest_mm = std::max(deepest_mm, each.depth_mm);
    }
    figure.bands.push_back(band);
    figure.curves.push_back(median);
  }
  figure.x = figures::axisOver(
      figureText(QT_TRANSLATE_NOOP("perilymph::gui", "insertion depth, mm")), 0.0, deepest_mm);
  figure.y = figures::axisOver(
      figureText(QT_TRANSLATE_NOOP("perilymph::gui", "axial insertion force, mN")), 0.0, top_mN);
  figure.notes.push_back(figureText(QT_TRANSLATE_NOOP(
      "perilymph::gui", "Lines: median; areas: 5 to 95 % of the draws that came that deep.")));
  return figure;
}

}  // namespace perilymph::gui
