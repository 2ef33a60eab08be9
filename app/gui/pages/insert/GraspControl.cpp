// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/GraspControl.h"

#include <QtCore/qnamespace.h>

#include "gui/run/UserSettings.h"

namespace perilymph::gui {

namespace {

constexpr Length perNotch = millimeters(0.25);  // of the wheel

}  // namespace

QStringList holdText() { return {QStringLiteral("press"), QStringLiteral("toggle")}; }

void GraspControl::hold(bool isHeld)
{
  if (control_.input() != InputSource::pointer) return;
  const bool isToggled =
      UserSettings().word(QStringLiteral("hold"), holdText()) == QLatin1String("toggle");
  if (!isToggled)
    control_.hold(isHeld);
  else if (isHeld)
    control_.hold(!control_.isHeld());
  Q_EMIT heldChanged(control_.isHeld());
}

void GraspControl::press(int key)
{
  if (control_.isHeld()) pressed_.insert(key);
  drive();
}

void GraspControl::release(int key)
{
  pressed_.erase(key);
  drive();
  if (key == Qt::Key_Space) hold(false);
}

bool GraspControl::turnWheel(double notches)
{
  if (!control_.isHeld()) return false;
  control_.advanceBy(-notches * perNotch);
  return true;
}

void GraspControl::drive()
{
  const int direction = int(pressed_.count(Qt::Key_Down)) - int(pressed_.count(Qt::Key_Up));
  control_.driveAt(direction * control_.scenario().speed());
}

void GraspControl::letGo()
{
  pressed_.clear();
  drive();
  Q_EMIT heldChanged(control_.isHeld());
}

}  // namespace perilymph::gui
