// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Overlays of the pages: devices, settings, keys and guide.

#include <QObject>

namespace perilymph::gui {

class AboutOverlay;
class DevicePage;
class Help;
class InsertPage;
class InsertionController;
class Navigation;
class ServersSection;
class SettingsOverlay;

/// Shows, hides and centers the overlays.
class OverlayStack : public QObject {
  Q_OBJECT
public:
  OverlayStack(InsertionController& insertion, InsertPage& page, Navigation& navigation,
               QWidget* window);

  Help& help() { return *help_; }
  void toggleDevices();
  /// Uses the device that was chosen last; shows the list if it is not there, or in use already.
  void useDevice();
  void toggleSettings();
  /// Shows the settings, with the focus in the archives.
  void showServers();
  void toggleAbout();

  /// Updates the overlays: what may be changed now, and the health of the device.
  void showState();
  /// Adapts to the size of the window.
  void place();
  /// Hides the topmost overlay. False if there is none; for the guide see Help::leaveGuide().
  bool leave();
  /// Whether an overlay is open that Esc closes on every page.
  bool wantsEscape() const;

Q_SIGNALS:
  /// A setting was changed that requires a new window.
  void settingChosen();
  /// The list of archives was changed.
  void serversChanged();

private:
  void placeDevices();
  void placeAtOnceAndLater();

  QWidget* window_;
  InsertionController& insertion_;
  InsertPage& page_;
  Help* help_;
  SettingsOverlay* settings_;
  ServersSection* servers_;
  DevicePage* devices_;
  AboutOverlay* about_;
};

}  // namespace perilymph::gui
