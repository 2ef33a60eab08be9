// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/SafetyStop.h"

namespace perilymph::gui {

bool SafetyStop::stopDevice()
{
  if (!control_.isDeviceActive()) return false;
  control_.pause();
  return true;
}

void SafetyStop::loseKeyboard()
{
  if (control_.input() == InputSource::pointer) control_.hold(false);
  control_.stopDeviceAfter(focusPatience);
}

void SafetyStop::regainKeyboard() { control_.continueDevice(); }

bool SafetyStop::onPageHidden()
{
  if (!control_.isMoving() && !control_.isHeld() && !control_.isDeviceActive()) return false;
  control_.pause();
  return true;
}

haptics::LoopStatistics SafetyStop::end() { return control_.halt(); }

}  // namespace perilymph::gui
