// The mouse on the operation view: it turns, moves and zooms the model.

#include <QEvent>
#include <QMouseEvent>
#include <cmath>

#include "OperationView.h"

namespace perilymph::gui {

namespace {

// A drag over the whole height of the picture turns the model half around.
constexpr double turnPerHeight_deg = 180.0;

}  // namespace

bool OperationView::event(QEvent* event)
{
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      // Past VTK, which would take them. NOLINTNEXTLINE(bugprone-parent-virtual-call)
      return QOpenGLWidget::event(event);
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

void OperationView::mousePressEvent(QMouseEvent* event)
{
  mouse_ = event->pos();
  event->accept();
}

void OperationView::mouseMoveEvent(QMouseEvent* event)
{
  const QPoint moved = event->pos() - mouse_;
  mouse_ = event->pos();
  const double right = double(moved.x()) / height();
  const double down = double(moved.y()) / height();
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if ((event->buttons() & Qt::MiddleButton) != 0 ||
      ((event->buttons() & Qt::LeftButton) != 0 && isShift))
    moveModel(right, -down);
  else if ((event->buttons() & Qt::LeftButton) != 0)
    turnModel(right * turnPerHeight_deg, down * turnPerHeight_deg, 0.0);
  else if ((event->buttons() & Qt::RightButton) != 0)
    zoom(std::exp(-2.0 * down));
  event->accept();
}

void OperationView::mouseReleaseEvent(QMouseEvent* event) { event->accept(); }

void OperationView::mouseDoubleClickEvent(QMouseEvent* event)
{
  event->accept();
  if (event->button() == Qt::LeftButton) Q_EMIT maximizeAsked();
}

}  // namespace perilymph::gui
