// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/StopTravel.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

constexpr Length shownTolerance = millimeters(0.05);  // shown as 0.0 mm

// lupdate assigns texts of free functions to their namespace.
QString translated(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

Length deepestStop(const electrode::ArrayDesign& array, Length startInside)
{
  const double nominal_um = inMillimeters(array.insertable - startInside) * 1e3;
  Length stop = millimeters(std::round(nominal_um) / 1e3);
  while (startInside + stop > array.insertable) stop = stop - millimeters(1e-3);
  return stop;
}

Length outsideAtStop(const session::Scenario& scenario)
{
  const Length outside =
      scenario.array().insertable - scenario.startInside() - scenario.stopTravel();
  return outside > shownTolerance ? outside : Length();
}

QString stopText(const session::Scenario& scenario)
{
  const Length outside = outsideAtStop(scenario);
  if (outside.si() <= 0.0)
    return translated(QT_TRANSLATE_NOOP("perilymph::gui", "full insertion of this array"));
  return translated(
             QT_TRANSLATE_NOOP("perilymph::gui", "partial insertion: %1 mm of the array outside"))
      .arg(numberText(inMillimeters(outside), 1));
}

QString stopChangeText(const session::Scenario& before, const session::Scenario& after)
{
  if (before.arrayName() == after.arrayName() || before.stopTravel() == after.stopTravel())
    return {};
  return translated(QT_TRANSLATE_NOOP("perilymph::gui", "%1: stop at %2 mm, %3."))
      .arg(QString::fromStdString(after.array().name),
           numberText(inMillimeters(after.stopTravel()), 1), stopText(after));
}

}  // namespace perilymph::gui
