// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/HeldArray.h"

#include <QtCore/qnamespace.h>

#include "gui/pages/insert/SidePanel.h"

namespace perilymph::gui {

namespace {

constexpr Length perNotch = millimeters(0.25);  // of the wheel

}  // namespace

void HeldArray::hold(bool isHeld)
{
  if (control_.hand() != InputSource::pointer) return;
  control_.hold(isHeld);
  side_.setHeld(control_.isHeld());
}

void HeldArray::press(int key)
{
  if (control_.isHeld()) pressed_.insert(key);
}

void HeldArray::release(int key)
{
  pressed_.erase(key);
  if (key == Qt::Key_Space) hold(false);
}

bool HeldArray::turnWheel(double notches)
{
  if (!control_.isHeld()) return false;
  control_.advanceBy(notches * perNotch);
  return true;
}

void HeldArray::step(double elapsed_s)
{
  const int direction = int(pressed_.count(Qt::Key_Down)) - int(pressed_.count(Qt::Key_Up));
  if (direction != 0)
    control_.advanceBy(Length::fromSi(direction * control_.scenario().speed().si() * elapsed_s));
}

void HeldArray::letGo()
{
  pressed_.clear();
  side_.setHeld(control_.isHeld());
}

}  // namespace perilymph::gui
