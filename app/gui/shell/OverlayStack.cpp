// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/OverlayStack.h"

#include <QTimer>
#include <algorithm>

#include "gui/archive/ServersSection.h"
#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/run/InputChoice.h"
#include "gui/run/WorkflowPredicates.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/AboutOverlay.h"
#include "gui/shell/Help.h"
#include "gui/shell/NavigationSection.h"
#include "gui/shell/SettingsOverlay.h"
#include "gui/widgets/SheetScroll.h"

namespace perilymph::gui {

OverlayStack::OverlayStack(InsertionController& insertion, InsertPage& page, Navigation& navigation,
                           QWidget* window)
    : QObject(window),
      window_(window),
      insertion_(insertion),
      page_(page),
      help_(new Help(window)),
      settings_(new SettingsOverlay(window)),
      servers_(new ServersSection(settings_)),
      devices_(new DevicePage(&page)),
      about_(new AboutOverlay(window))
{
  settings_->append(servers_);
  settings_->append(new NavigationSection(navigation, settings_));
  connect(servers_, &ServersSection::changed, this, &OverlayStack::serversChanged);
  connect(settings_, &SettingsOverlay::closeRequested, this, &OverlayStack::toggleSettings);
  connect(settings_, &SettingsOverlay::chosen, this, &OverlayStack::settingChosen);
  connect(about_, &AboutOverlay::closeRequested, this, &OverlayStack::toggleAbout);
  connect(&page, &InsertPage::devicesRequested, this, &OverlayStack::useDevice);
  connect(devices_, &DevicePage::closeRequested, this, &OverlayStack::toggleDevices);
  connect(devices_, &DevicePage::deviceChosen, this, [this](const device::FoundDevice& found) {
    rememberInput(found);
    insertion_.useDevice(found);
  });
  connect(devices_, &DevicePage::pluginChosen, this, [this](const device::FoundPlugin& plugin) {
    rememberInput(plugin.file);
    insertion_.useDevice(plugin.file);
  });
}

void OverlayStack::useDevice()
{
  const bool isInUse = insertion_.control().input() == InputSource::device;
  const auto remembered = isInUse ? std::nullopt : rememberedInput();
  if (!remembered) return toggleDevices();
  insertion_.useDevice(*remembered);
  page_.showInput();
}

void OverlayStack::toggleDevices()
{
  devices_->setVisible(!devices_->isVisible());
  if (devices_->isVisible()) {
    showState();
    devices_->refresh();
    place();
    devices_->raise();
  }
  page_.showInput();  // requesting the page toggles its button
}

void OverlayStack::toggleSettings()
{
  settings_->setVisible(!settings_->isVisible());
  if (!settings_->isVisible()) return window_->setFocus();
  help_->leaveKeys();
  placeAtOnceAndLater();
  settings_->raise();
}

void OverlayStack::showServers()
{
  if (!settings_->isVisible()) toggleSettings();
  servers_->focusFirst();
  // once the sheet has its size
  QTimer::singleShot(0, this, [this] { settings_->scrollTo(*servers_); });
}

void OverlayStack::toggleAbout()
{
  about_->setVisible(!about_->isVisible());
  if (!about_->isVisible()) return window_->setFocus();
  help_->leaveKeys();
  placeAtOnceAndLater();
  about_->raise();
}

/// A sheet that was just shown gets its style, and so its size, with the next events.
void OverlayStack::placeAtOnceAndLater()
{
  place();
  QTimer::singleShot(0, this, &OverlayStack::place);
}

void OverlayStack::showState()
{
  InsertionControl& control = insertion_.control();
  const bool isChangeable = isBetweenInsertions(stateOf(control));
  settings_->setChangeable(isChangeable);
  devices_->setChangeable(isChangeable);
  if (!devices_->isVisible()) return;
  devices_->showInUse(QString::fromStdString(control.inputName()), control.deviceHealth(),
                      control.now(), QString::fromStdString(control.couplingText()));
}

void OverlayStack::place()
{
  if (devices_->isVisible()) placeDevices();
  if (settings_->isVisible()) fitSheet(*settings_);
  if (about_->isVisible()) fitSheet(*about_);
  help_->place();
}

/// In the middle of the 3D view as far as it is wide enough, and above the buttons below it.
void OverlayStack::placeDevices()
{
  const OperationView& view = *page_.views().operation();
  devices_->fitAbove(view.isVisible() ? view.mapTo(&page_, view.rect().bottomLeft()).y()
                                      : page_.height());
  const QPoint corner = view.mapTo(&page_, view.rect().center()) - devices_->rect().center();
  const int right = std::max(0, page_.width() - devices_->width());
  devices_->move(std::clamp(corner.x(), 0, right), std::max(0, corner.y()));
}

bool OverlayStack::leave()
{
  if (help_->leaveKeys()) return true;
  if (about_->isVisible())
    toggleAbout();
  else if (settings_->isVisible())
    toggleSettings();
  else if (devices_->isVisible())
    toggleDevices();
  else
    return false;
  return true;
}

bool OverlayStack::wantsEscape() const
{
  return help_->areKeysShown() || settings_->isVisible() || about_->isVisible();
}

}  // namespace perilymph::gui
