// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/Help.h"

#include "gui/shell/GuideOverlay.h"
#include "gui/shell/KeyList.h"

namespace perilymph::gui {

Help::Help(QWidget* window) : QObject(window), window_(window), guide_(new GuideOverlay(window))
{
  connect(guide_, &GuideOverlay::closeRequested, this, &Help::toggleGuide);
}

void Help::listKeys(const KeyActions& actions)
{
  keys_ = new KeyList(actions, window_);
  connect(keys_, &KeyList::guideRequested, this, &Help::toggleGuide);
}

void Help::toggleKeys()
{
  keys_->fit();
  keys_->setVisible(!keys_->isVisible());
  keys_->raise();
}

void Help::toggleGuide()
{
  keys_->hide();
  if (guide_->isHidden()) return guide_->open();
  guide_->hide();
  window_->setFocus();
}

bool Help::areKeysShown() const { return keys_->isVisible(); }

bool Help::leaveGuide()
{
  if (!guide_->isVisible()) return false;
  toggleGuide();
  return true;
}

bool Help::leaveKeys()
{
  if (!areKeysShown()) return false;
  toggleKeys();
  return true;
}

void Help::place()
{
  if (areKeysShown()) keys_->fit();
}

}  // namespace perilymph::gui
