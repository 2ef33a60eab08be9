// Keys and wheel of the main window.

#include <QEvent>
#include <QKeyEvent>
#include <QWheelEvent>
#include <cmath>

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/pages/validate/ValidatePage.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/SettingsSheet.h"

namespace perilymph::gui {

namespace {

constexpr double magnify = 1.1;                 // per notch of the wheel
constexpr Length perNotch = millimeters(0.25);  // of the wheel, while the array is held

}  // namespace

void MainWindow::keyPressEvent(QKeyEvent* event)
{
  if (page_ == Page::insert && keyOfReplay(event)) return;
  if (!keyActions_.take(*event)) QWidget::keyPressEvent(event);
}

void MainWindow::keyReleaseEvent(QKeyEvent* event)
{
  if (event->isAutoRepeat()) return;
  pressed_.erase(event->key());
  if (event->key() == Qt::Key_Space) hold(false);
}

void MainWindow::wheelEvent(QWheelEvent* event)
{
  if (page_ != Page::insert) return QWidget::wheelEvent(event);
  const double notches = event->angleDelta().y() / 120.0;
  const bool isControl = (event->modifiers() & Qt::ControlModifier) != 0;
  // Turning the wheel away from oneself pushes the array in.
  if (control_.isHeld() && !isControl)
    control_.advanceBy(notches * perNotch);
  else
    view_->zoom(std::pow(magnify, notches));
  event->accept();
}

bool MainWindow::event(QEvent* event)
{
  // A key released in another window is never told to this one: let go of the array at once.
  if (event->type() == QEvent::WindowDeactivate) {
    pressed_.clear();
    safety_.loseKeyboard();
    side_->setHeld(control_.isHeld());
  }
  return QWidget::event(event);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  safety_.end();
  QWidget::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  if (devices_->isVisible()) devices_->move(view_->rect().center() - devices_->rect().center());
  if (settings_->isVisible()) settings_->move(rect().center() - settings_->rect().center());
  if (keys_->isVisible()) keys_->move(rect().center() - keys_->rect().center());
}

}  // namespace perilymph::gui
