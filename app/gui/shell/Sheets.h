#pragma once

// What lies on the pages when asked for: devices, settings, keys and guide.

#include <QObject>

namespace perilymph::gui {

class DevicePage;
class Help;
class InsertPage;
class SettingsSheet;

/// Shows and hides the sheets and keeps them in the middle.
class Sheets : public QObject {
  Q_OBJECT
public:
  Sheets(InsertPage& insertion, QWidget* window);

  Help& help() { return *help_; }
  void toggleDevices();
  void toggleSettings();

  /// The insertion goes on: what may be chosen now, and how its device is doing.
  void showState();
  /// The window has another size.
  void place();
  /// Hides the one on top. False if there is none; the guide is asked for by Help::leaveGuide().
  bool leave();
  /// Esc is for a sheet that lies on every page.
  bool wantsEscape() const;

Q_SIGNALS:
  /// Something was chosen that a window made anew will show.
  void settingChosen();

private:
  QWidget* window_;
  InsertPage& insertion_;
  Help* help_;
  SettingsSheet* settings_;
  DevicePage* devices_;
};

}  // namespace perilymph::gui
