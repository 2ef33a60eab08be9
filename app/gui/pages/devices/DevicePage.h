// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The connected devices, and the health of the one in use.

#include <QFrame>
#include <optional>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/haptics/Snapshot.h"

class QLabel;
class QVBoxLayout;

namespace perilymph::gui {

/// An overlay of the 3D view. Same content as `perilymph-cli devices`, and live data of the device
/// in use.
class DevicePage : public QFrame {
  Q_OBJECT
public:
  explicit DevicePage(QWidget* parent);

  /// Searches for devices again, without opening any.
  void refresh();
  /// Enables selection of devices, possible before and after an insertion only.
  void setChangeable(bool isChangeable);
  /// Shows the device in use.
  ///
  /// @param coupling  A message if the device cannot render the requested coupling; else empty.
  void showInUse(const QString& name, const std::optional<device::DeviceHealth>& health,
                 const haptics::Snapshot& now, const QString& coupling);

Q_SIGNALS:
  void deviceChosen(const perilymph::device::FoundDevice& found);
  void closeRequested();

private:
  void fit();
  void addDevice(const device::FoundDevice& found);
  QLabel* addText(QVBoxLayout& column, const QString& text, bool isQuiet);

  QLabel* inUse_;
  QLabel* live_;
  QWidget* list_ = nullptr;
  QVBoxLayout* column_;
  bool isChangeable_ = true;
};

}  // namespace perilymph::gui
