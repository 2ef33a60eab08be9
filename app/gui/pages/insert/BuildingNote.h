// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Message about building a cochlea, shown at the bottom of the 3D view after a second.

#include "gui/widgets/Overlay.h"

class QLabel;

namespace perilymph::gui {

/// Reports that the window waits for a cochlea, and offers to cancel.
class BuildingNote : public Overlay {
  Q_OBJECT
public:
  /// Shorter waits end before the message could be read.
  static constexpr int patience_ms = 1000;

  /// Placed over `page`, whose size it follows.
  explicit BuildingNote(QWidget* page);

  /// @param busyFor_ms  Time since building started; 0 if nothing is being built.
  void show(qint64 busyFor_ms);

Q_SIGNALS:
  void cancelRequested();

protected:
  void place() override;

private:
  QLabel* text_;
};

}  // namespace perilymph::gui
