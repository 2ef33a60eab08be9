// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/Legibility.h"

#include <QFontMetricsF>
#include <QScreen>
#include <cmath>

#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double inch_mm = 25.4;
constexpr double usualDotsPerInch = 96.0;
// Screens of 4 to 100 inches have pixels between these; a size outside is none (choice, high).
constexpr double finestPitch_mm = 0.05, coarsestPitch_mm = 2.0;
constexpr int largeType_px = 200;  // at which the height of capitals is measured

/// Height of a capital over the size of the type: 0.73 of Inter.
double capitalShare()
{
  const QFont font = typeface(largeType_px);
  return QFontMetricsF(font).capHeight() / font.pixelSize();
}

}  // namespace

double heightSeen_mm(double angle_arcmin, double distance_mm)
{
  constexpr double arcminPerDegree = 60.0;
  return 2.0 * distance_mm * std::tan(0.5 * degrees(angle_arcmin / arcminPerDegree).si());
}

int letterSize_px(double angle_arcmin, double pitch_mm)
{
  const double capital_px = heightSeen_mm(angle_arcmin, visitorDistance_mm) / pitch_mm;
  return static_cast<int>(std::ceil(capital_px / capitalShare()));
}

double pixelPitch_mm(const QScreen* screen)
{
  constexpr double usual_mm = inch_mm / usualDotsPerInch;
  if (screen == nullptr || screen->physicalSize().isEmpty()) return usual_mm;
  const double stated_mm = inch_mm / screen->physicalDotsPerInch();
  return stated_mm > finestPitch_mm && stated_mm < coarsestPitch_mm ? stated_mm : usual_mm;
}

}  // namespace perilymph::gui
