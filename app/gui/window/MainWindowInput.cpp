// Keys and wheel of the main window.

#include <QEvent>
#include <QKeyEvent>
#include <QWheelEvent>
#include <cmath>

#include "DevicePage.h"
#include "KeyList.h"
#include "MainWindow.h"
#include "OperationView.h"
#include "SidePanel.h"
#include "ValidatePage.h"

namespace perilymph::gui {

namespace {

using visualization::CameraPreset;

constexpr double turn_deg = 5.0;    // per press of A, D, W, X
constexpr double moveShare = 0.03;  // per press of Shift and an arrow, of the picture's height
constexpr double magnify = 1.1;     // per press of + or a notch of the wheel
constexpr Length perNotch = millimeters(0.25);  // of the wheel, while the array is held

}  // namespace

void MainWindow::keyPressEvent(QKeyEvent* event)
{
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  const bool isControl = (event->modifiers() & Qt::ControlModifier) != 0;
  const int key = event->key();

  if ((event->modifiers() & Qt::AltModifier) != 0) {
    if (key == Qt::Key_Home) return showPage(Page::start);
    if (key == Qt::Key_1) return showPage(Page::insert);
    if (key == Qt::Key_2) return showPage(Page::compare);
    if (key == Qt::Key_3) return showPage(Page::validate);
    if (key == Qt::Key_4) return showPage(Page::sessions);
    return QWidget::keyPressEvent(event);
  }
  if (page_ == Page::validate && key == Qt::Key_Escape) return validation_->cancel();
  if (page_ != Page::insert) return QWidget::keyPressEvent(event);
  if (isControl && key == Qt::Key_R) return reset();
  if (isControl) return QWidget::keyPressEvent(event);
  if (key == Qt::Key_Space) {
    if (event->isAutoRepeat()) return;
    if (control_.hand() == Hand::pointer) {
      if (!control_.isRunning()) start();
      hold(true);
    } else if (control_.isMoving()) {
      pause();
    } else {
      start();
    }
    return;
  }
  if (!isShift && (key == Qt::Key_Up || key == Qt::Key_Down)) {
    if (control_.isHeld()) pressed_.insert(key);
    return;
  }
  if (key == Qt::Key_Escape) {
    if (keys_->isVisible()) return toggleKeyList();
    if (devices_->isVisible()) return toggleDevices();
    return pause();
  }
  if (key == Qt::Key_Backspace) return withdraw();
  if (key == Qt::Key_Question) return toggleKeyList();
  if (key == Qt::Key_H) return toggleDevices();
  if (key == Qt::Key_S) return control_.pullStylet();
  if (!steer(key, isShift)) QWidget::keyPressEvent(event);
}

bool MainWindow::steer(int key, bool isShift)
{
  switch (key) {
    case Qt::Key_1:
      view_->glideTo(CameraPreset::surgeon);
      return true;
    case Qt::Key_2:
      view_->glideTo(CameraPreset::microscope);
      return true;
    case Qt::Key_3:
      view_->glideTo(CameraPreset::overview);
      return true;
    case Qt::Key_4:
      view_->glideTo(CameraPreset::section);
      return true;
    case Qt::Key_F:
      view_->glideTo(CameraPreset::followTip);
      return true;
    case Qt::Key_A:
      view_->turnModel(-turn_deg, 0.0, 0.0);
      return true;
    case Qt::Key_D:
      view_->turnModel(turn_deg, 0.0, 0.0);
      return true;
    case Qt::Key_W:
      view_->turnModel(0.0, -turn_deg, 0.0);
      return true;
    case Qt::Key_X:
      view_->turnModel(0.0, turn_deg, 0.0);
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      view_->zoom(magnify);
      return true;
    case Qt::Key_Minus:
      view_->zoom(1.0 / magnify);
      return true;
    default:
      break;
  }
  if (!isShift) return false;
  switch (key) {
    case Qt::Key_Left:
      view_->moveModel(-moveShare, 0.0);
      return true;
    case Qt::Key_Right:
      view_->moveModel(moveShare, 0.0);
      return true;
    case Qt::Key_Up:
      view_->moveModel(0.0, moveShare);
      return true;
    case Qt::Key_Down:
      view_->moveModel(0.0, -moveShare);
      return true;
    default:
      return false;
  }
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
    hold(false);
  }
  return QWidget::event(event);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  if (devices_->isVisible()) devices_->move(view_->rect().center() - devices_->rect().center());
  if (keys_->isVisible()) keys_->move(view_->rect().center() - keys_->rect().center());
}

void MainWindow::toggleKeyList()
{
  keys_->adjustSize();
  keys_->move(view_->rect().center() - keys_->rect().center());
  keys_->setVisible(!keys_->isVisible());
  keys_->raise();
}

}  // namespace perilymph::gui
