#pragma once

// Which devices there are, what each is, and how the one in use is doing.

#include <QFrame>
#include <optional>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/haptics/Snapshot.h"

class QLabel;
class QVBoxLayout;

namespace perilymph::gui {

/// Lies on the picture. The same content as `perilymph-cli devices`, and the hand in use live.
class DevicePage : public QFrame {
  Q_OBJECT
public:
  explicit DevicePage(QWidget* parent);

  /// Looks at the devices anew. None is opened.
  void refresh();
  /// Devices can be chosen before an insertion and after it, not during one.
  void setChangeable(bool isChangeable);
  /// The hand in use.
  ///
  /// @param coupling  A sentence where the device renders less than was asked for; else empty.
  void showHand(const QString& name, const std::optional<device::DeviceHealth>& health,
                const haptics::Snapshot& now, const QString& coupling);

Q_SIGNALS:
  void deviceChosen(const perilymph::device::FoundDevice& found);
  void closeAsked();

private:
  void fit();
  void addDevice(const device::FoundDevice& found);
  QLabel* addText(QVBoxLayout& column, const QString& text, bool isQuiet);

  QLabel* hand_;
  QLabel* live_;
  QWidget* list_ = nullptr;
  QVBoxLayout* column_;
  bool isChangeable_ = true;
};

}  // namespace perilymph::gui
