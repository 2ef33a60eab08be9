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

constexpr double sideOverLetter = 0.7;  // margin at which the speeds begin and end

}  // namespace

SpeedPad::SpeedPad(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("pushPad"));
  setCursor(Qt::PointingHandCursor);
  retranslate();
}

void SpeedPad::retranslate()
{
  setAccessibleName(tr("Hold here to insert"));
  update();
}

void SpeedPad::setLetterSize(int size_px)
{
  letter_px_ = size_px;
  update();
}

int SpeedPad::side() const { return qRound(sideOverLetter * sized(letter_px_)); }

Speed SpeedPad::speed() const
{
  if (!place_) return Speed::fromSi(0.0);
  return Speed::fromSi(slowest.si() + *place_ * (fastest.si() - slowest.si()));
}

void SpeedPad::hold(int x)
{
  const bool wasHeld = isHeld();
  place_ = std::clamp(double(x - side()) / std::max(1, width() - 2 * side()), 0.0, 1.0);
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
    const double end = side() + *place_ * (width() - 2 * side());
    painter.fillRect(QRectF(0, 0, end, height()), filled);
    painter.restore();
  }
  painter.setPen(QPen(shownTheme().accent, isHeld() ? 3.0 : 2.0));
  painter.drawPath(plate);

  const QColor ink = isEnabled() ? shownTheme().text : shownTheme().quietText;
  painter.setPen(ink);
  painter.setFont(typeface(letter_px_, QFont::DemiBold));
  const QRect inside = rect().adjusted(side(), 4, -side(), -4);
  painter.drawText(inside, Qt::AlignHCenter | Qt::AlignTop,
                   isHeld() ? tr("Release to pause") : tr("Hold here to insert"));
  painter.setFont(typeface(letter_px_));
  painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom, tr("slow"));
  painter.drawText(inside, Qt::AlignRight | Qt::AlignBottom, tr("fast"));
}

}  // namespace perilymph::gui
