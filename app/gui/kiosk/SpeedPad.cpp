// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/SpeedPad.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int height_px = 96;
constexpr int side_px = 24;

}  // namespace

SpeedPad::SpeedPad(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("pushPad"));
  setAccessibleName(tr("Hold here to insert"));
  setFixedHeight(height_px);
  setMinimumWidth(4 * height_px);
  setCursor(Qt::PointingHandCursor);
}

Speed SpeedPad::speed() const
{
  if (!place_) return Speed::fromSi(0.0);
  return Speed::fromSi(slowest.si() + *place_ * (fastest.si() - slowest.si()));
}

void SpeedPad::hold(int x)
{
  const bool wasHeld = isHeld();
  place_ = std::clamp(double(x - side_px) / std::max(1, width() - 2 * side_px), 0.0, 1.0);
  update();
  if (!wasHeld) Q_EMIT heldChanged(true);
}

void SpeedPad::release()
{
  if (!isHeld()) return;
  place_.reset();
  update();
  Q_EMIT heldChanged(false);
}

void SpeedPad::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton) hold(event->pos().x());
}

void SpeedPad::mouseMoveEvent(QMouseEvent* event)
{
  if (isHeld()) hold(event->pos().x());
}

void SpeedPad::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton) release();
}

void SpeedPad::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::EnabledChange && !isEnabled()) release();
  QWidget::changeEvent(event);
}

void SpeedPad::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath plate;
  plate.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 10, 10);
  painter.fillPath(plate, shownTheme().raised);
  if (place_) {
    painter.save();
    painter.setClipPath(plate);
    QColor filled = shownTheme().accent;
    filled.setAlpha(90);
    const double end = side_px + *place_ * (width() - 2 * side_px);
    painter.fillRect(QRectF(0, 0, end, height()), filled);
    painter.restore();
  }
  painter.setPen(QPen(shownTheme().accent, isHeld() ? 3.0 : 2.0));
  painter.drawPath(plate);

  const QColor ink = isEnabled() ? shownTheme().text : shownTheme().quietText;
  painter.setPen(ink);
  painter.setFont(typeface(26, QFont::DemiBold));
  const QRect text = rect().adjusted(side_px, 8, -side_px, -36);
  painter.drawText(text, Qt::AlignCenter,
                   isHeld() ? tr("Release to pause") : tr("Hold here to insert"));
  painter.setFont(typeface(16));
  const QRect foot = rect().adjusted(side_px, 54, -side_px, -8);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, tr("slow"));
  painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, tr("fast"));
}

}  // namespace perilymph::gui
