// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/ApproachText.h"

#include <QCoreApplication>
#include <cmath>

#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

constexpr double shown_deg = 0.1;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// "5.0°" with one of two directions, or without one if that is 0.0.
QString angleText(Angle angle, const QString& positive, const QString& negative)
{
  const double value = std::fabs(inDegrees(angle));
  const QString number = numberText(value, 1);
  if (value < 0.5 * shown_deg) return tr("%1°").arg(number);
  return (angle.si() > 0.0 ? positive : negative).arg(number);
}

}  // namespace

QString inPlaneText(const anatomy::BasalTurnAngles& angles)
{
  return angleText(angles.inPlane, tr("%1° toward the lateral wall"),
                   tr("%1° toward the modiolus"));
}

QString outOfPlaneText(const anatomy::BasalTurnAngles& angles)
{
  return angleText(angles.outOfPlane, tr("%1° toward the basilar membrane"),
                   tr("%1° toward the floor of the scala tympani"));
}

QString approachText(const anatomy::BasalTurnAngles& angles)
{
  return tr("%1 in the plane of the basal turn, %2 out of it")
      .arg(inPlaneText(angles), outOfPlaneText(angles));
}

QString approachLimitText()
{
  return tr("The simulation allows at most %1° of tilt and of turn from the axis of the opening.")
      .arg(numberText(anatomy::steepestApproach_deg, 0));
}

}  // namespace perilymph::gui
