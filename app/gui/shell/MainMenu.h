// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The menu at the right of the top bar.

#include <QMenu>

namespace perilymph::gui {

class MainWindow;

/// Actions of the program. Those that would end an insertion require a confirmation.
class MainMenu : public QMenu {
  Q_OBJECT
public:
  MainMenu(MainWindow& window, QWidget* parent);

private:
  void openRecording();

  MainWindow& window_;
};

}  // namespace perilymph::gui
