// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The connected devices, and the health of the one in use.

#include <QFrame>
#include <optional>
#include <vector>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/haptics/Snapshot.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class Background;
class SheetScroll;

/// An overlay of the 3D view. Same content as `perilymph-cli devices`, and live data of the device
/// in use. The list scrolls where the view is too low for it.
class DevicePage : public QFrame {
  Q_OBJECT
public:
  explicit DevicePage(QWidget* parent);

  /// Searches for devices again, without opening any; for plug-ins in the background, because each is
  /// loaded for a moment, and not during an insertion.
  void refresh();
  /// Takes the height of its content, at most down to this one of its parent, and scrolls the rest.
  void fitAbove(int bottom);
  /// Enables selection of devices, possible before and after an insertion only.
  void setChangeable(bool isChangeable);
  /// Shows the device in use.
  ///
  /// @param coupling  A message if the device cannot render the requested coupling; else empty.
  void showInUse(const QString& name, const std::optional<device::DeviceHealth>& health,
                 const haptics::Snapshot& now, const QString& coupling);

Q_SIGNALS:
  void deviceChosen(const perilymph::device::FoundDevice& found);
  void pluginChosen(const perilymph::device::FoundPlugin& plugin);
  void closeRequested();

private:
  void fit();
  void fillList();
  void addDevice(const device::FoundDevice& found, const device::DeviceSurvey& survey);
  void addPlugins();
  void addPlugin(const device::FoundPlugin& plugin);
  void addTitle(const QString& title);
  QPushButton* addRow(const QString& title, bool isRemembered);
  QLabel* addText(const QString& text, bool isQuiet);

  QLabel* inUse_;
  QLabel* live_;
  QWidget* list_ = nullptr;
  SheetScroll* scroll_ = nullptr;
  QVBoxLayout* column_;
  Background* search_;
  std::vector<device::FoundPlugin> plugins_;  ///< What the last search found.
  int bottom_ = 0;  ///< The lowest place in its parent that it may take; 0: the parent's bottom.
  bool isChangeable_ = true;
};

}  // namespace perilymph::gui
