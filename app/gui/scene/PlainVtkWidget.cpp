// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/PlainVtkWidget.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QEvent>
#include <QPainter>

#include "gui/scene/ComposedPicture.h"
#include "gui/scene/CopiedPicture.h"
#include "gui/scene/RendererName.h"

namespace perilymph::gui {

PictureWay usualPictureWay()
{
  return isSoftwareRenderer(openGlRenderer()) ? PictureWay::copied : PictureWay::composed;
}

PlainVtkWidget::PlainVtkWidget(QWidget* parent, PictureWay way) : QWidget(parent)
{
  window_->SetMultiSamples(0);
  window_->SetReadyForRendering(false);  // before the view is shown
  setMouseTracking(true);
  if (way == PictureWay::composed) {
    composed_ = new ComposedPicture(*window_, this);
    connect(composed_, &QOpenGLWidget::frameSwapped, this, &PlainVtkWidget::presented);
  } else {
    setAttribute(Qt::WA_OpaquePaintEvent);
  }
}

PlainVtkWidget::~PlainVtkWidget() = default;

vtkRenderWindow* PlainVtkWidget::renderWindow() const { return window_; }

bool PlainVtkWidget::isValid() const
{
  return composed_ != nullptr ? composed_->isValid() : copied_ && copied_->isValid();
}

QImage PlainVtkWidget::picture()
{
  if (composed_ != nullptr) return composed_->grabFramebuffer();
  beginCopying();
  QImage picture = copied_->image();
  picture.setDevicePixelRatio(devicePixelRatioF());
  return picture;
}

bool PlainVtkWidget::event(QEvent* event)
{
  if (event->type() == QEvent::ScreenChangeInternal) fitPicture();
  return QWidget::event(event);
}

/// Updates of a part spare the texts elsewhere in the view.
void PlainVtkWidget::beginCopying()
{
  if (copied_) return;
  copied_ = std::make_unique<CopiedPicture>(*window_, [this](const QRegion& changed_px) {
    const double ratio = devicePixelRatioF();
    QRegion changed;
    for (const QRect& part : changed_px)
      changed +=
          QRectF(part.x() / ratio, part.y() / ratio, part.width() / ratio, part.height() / ratio)
              .toAlignedRect();
    update(changed);
  });
  fitPicture();
}

/// The picture has the size of the view.
void PlainVtkWidget::fitPicture()
{
  if (composed_ != nullptr) composed_->setGeometry(rect());
  if (copied_) copied_->resize(size() * devicePixelRatioF());
}

void PlainVtkWidget::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  fitPicture();
}

void PlainVtkWidget::paintEvent(QPaintEvent*)
{
  if (composed_ != nullptr) return;
  beginCopying();
  QPainter painter(this);
  const double ratio = devicePixelRatioF();
  painter.scale(1.0 / ratio, 1.0 / ratio);  // pixel for pixel
  painter.drawImage(QPoint(0, 0), copied_->image());
  // the window is passed on when all of it is painted
  QMetaObject::invokeMethod(this, &PlainVtkWidget::presented, Qt::QueuedConnection);
}

}  // namespace perilymph::gui
