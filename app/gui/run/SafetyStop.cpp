// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/SafetyStop.h"

namespace perilymph::gui {

void SafetyStop::loseKeyboard()
{
  if (control_.hand() == InputSource::pointer) control_.hold(false);
}

bool SafetyStop::leaveSight()
{
  if (!control_.isMoving() && !control_.isHeld()) return false;
  control_.pause();
  return true;
}

void SafetyStop::end() { control_.halt(); }

}  // namespace perilymph::gui
