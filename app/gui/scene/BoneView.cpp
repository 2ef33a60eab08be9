// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/BoneView.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "gui/scene/RendererName.h"
#include "gui/scene/SceneLabels.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double keyTurn_deg = 5.0;
constexpr int rest_ms = 250;  // without motion

}  // namespace

BoneView::BoneView(double zoomPerNotch, QWidget* parent)
    : PlainVtkWidget(parent), zoomPerNotch_(zoomPerNotch), labels_(new SceneLabels(*this))
{
  setFocusPolicy(Qt::StrongFocus);
  rest_.setSingleShot(true);
  rest_.setInterval(rest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (layer() == nullptr) return;
    layer()->setMoving(false);
    render();
  });
}

void BoneView::render()
{
  // before the widget is shown it has no OpenGL context; VTK renders when it gets one
  if (isValid()) renderWindow()->Render();
  labels_->follow(layer(), {}, isApproachTurnable());
  update();
}

void BoneView::renderMoving()
{
  // a graphics card always draws the fine surface
  layer()->setMoving(isSoftwareRenderer(openGlRenderer()));
  render();
  rest_.start();
  onMoved();
}

void BoneView::setNote(const QString& note)
{
  note_ = note;
  labels_->setNote(note_, {spacing, spacing}, width() - 2 * spacing);
}

void BoneView::resizeEvent(QResizeEvent* event)
{
  PlainVtkWidget::resizeEvent(event);
  setNote(note_);
  if (layer() != nullptr) render();
}

void BoneView::focusInEvent(QFocusEvent* event)
{
  PlainVtkWidget::focusInEvent(event);
  labels_->update();
}

void BoneView::focusOutEvent(QFocusEvent* event)
{
  PlainVtkWidget::focusOutEvent(event);
  labels_->update();
}

void BoneView::mousePressEvent(QMouseEvent* event)
{
  mouse_ = event->localPos();
  const bool isLeft = event->button() == Qt::LeftButton;
  const bool isControl = (event->modifiers() & Qt::ControlModifier) != 0;
  if (const auto handle = labels_->approachHandle();
      isLeft && !isControl && handle && labels_->isApproachHandleAt(mouse_)) {
    heldApproach_ = HeldApproach{handle->at - mouse_, handle->toViewer_mm};
    beginApproach();
    return;
  }
  isCutHeld_ = isLeft && (labels_->isHandleAt(mouse_) || isControl);
}

void BoneView::mouseMoveEvent(QMouseEvent* event)
{
  const QPointF moved = event->localPos() - mouse_;
  const QPointF part = moved / height();
  mouse_ = event->localPos();
  if (layer() == nullptr) return;
  if (heldApproach_) return followApproach();
  if (isCutHeld_)
    layer()->moveCut(labels_->cutMotion_mm(moved));
  else if ((event->buttons() & Qt::LeftButton) != 0)
    rotateScene(turnPerHeight_deg * part.x(), turnPerHeight_deg * part.y());
  else if ((event->buttons() & Qt::RightButton) != 0)
    zoomScene(std::exp(-2.0 * part.y()));
  else
    return;
  renderMoving();
}

void BoneView::mouseReleaseEvent(QMouseEvent* event)
{
  isCutHeld_ = false;
  event->accept();
  if (!heldApproach_ || event->button() != Qt::LeftButton) return;
  heldApproach_.reset();
  endApproach(false);
}

void BoneView::followApproach()
{
  const QPointF at = (mouse_ + heldApproach_->aside) * devicePixelRatioF();
  const auto outward = layer()->approachTo({at.x(), at.y()}, heldApproach_->toViewer_mm);
  if (!outward) return;
  turnApproach(*outward);
  renderMoving();
}

void BoneView::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton) Q_EMIT maximizeRequested();
}

void BoneView::wheelEvent(QWheelEvent* event)
{
  event->accept();
  if (layer() == nullptr) return;
  zoomScene(std::pow(zoomPerNotch_, event->angleDelta().y() / 120.0));
  renderMoving();
}

void BoneView::keyPressEvent(QKeyEvent* event)
{
  if (layer() == nullptr) return PlainVtkWidget::keyPressEvent(event);
  if (heldApproach_ && event->key() == Qt::Key_Escape) {
    heldApproach_.reset();
    endApproach(true);
    return renderMoving();
  }
  switch (event->key()) {
    case Qt::Key_PageUp:
      layer()->moveCut(cutOfKey_mm);
      break;
    case Qt::Key_PageDown:
      layer()->moveCut(-cutOfKey_mm);
      break;
    case Qt::Key_V:
      layer()->faceCut();
      break;
    case Qt::Key_Left:
      rotateScene(-keyTurn_deg, 0.0);
      break;
    case Qt::Key_Right:
      rotateScene(keyTurn_deg, 0.0);
      break;
    case Qt::Key_Up:
      rotateScene(0.0, -keyTurn_deg);
      break;
    case Qt::Key_Down:
      rotateScene(0.0, keyTurn_deg);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoomScene(zoomPerNotch_);
      break;
    case Qt::Key_Minus:
      zoomScene(1.0 / zoomPerNotch_);
      break;
    default:
      return PlainVtkWidget::keyPressEvent(event);
  }
  event->accept();
  renderMoving();
}

}  // namespace perilymph::gui
