// What was recorded, in the main window: the library and what is asked of it.

#include "ComparePage.h"
#include "MainWindow.h"
#include "SessionsPage.h"

namespace perilymph::gui {

void MainWindow::connectSessions() {}

void MainWindow::showSessions() {
  sessions_->refresh(control_.recording());
  sessions_->setFocus();
}

}  // namespace perilymph::gui
