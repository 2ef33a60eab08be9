// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/ReadOutTips.h"

#include <QCoreApplication>
#include <QToolTip>
#include <QWidget>

#include "gui/scene/PhaseLine.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tipText(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

void ReadOutTips::set() const
{
  travel->setToolTip(tipText(QT_TRANSLATE_NOOP(
      "perilymph::gui",
      "Advance of the array since the start of the insertion. Insertion depth: length past the "
      "round window.")));
  angle->setToolTip(tipText(QT_TRANSLATE_NOOP(
      "perilymph::gui",
      "Angular insertion depth: angle of the most apical contact about the modiolar axis, from the "
      "round window. The tip lies deeper.")));
  force->setToolTip(tipText(
      QT_TRANSLATE_NOOP("perilymph::gui",
                        "Axial force on the hand that inserts the array; positive while it pushes "
                        "in.")));
  speed->setToolTip(
      tipText(QT_TRANSLATE_NOOP("perilymph::gui", "Speed of the array along the insertion axis.")));
  magnification->setToolTip(tipText(QT_TRANSLATE_NOOP(
      "perilymph::gui", "Magnification of a surgical microscope with the same field.")));
}

bool ReadOutTips::show(QWidget& view, const QPoint& place, const QPoint& onScreen) const
{
  for (const QWidget* part : {travel, angle, force, forceLabel, speed, magnification, viewName}) {
    if (!part->isVisible() || !part->geometry().contains(place)) continue;
    QToolTip::showText(onScreen, part->toolTip(), &view, part->geometry());
    return true;
  }
  if (!phase->isVisible() || !phase->geometry().contains(place)) return false;
  QToolTip::showText(onScreen, phase->tipAt(place - phase->pos()), &view);
  return true;
}

}  // namespace perilymph::gui
