// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/ElidedLabel.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "gui/parts/Theme.h"

namespace perilymph::gui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {}

QSize ElidedLabel::minimumSizeHint() const
{
  return {std::min(sized(64), sizeHint().width()), sizeHint().height()};
}

bool ElidedLabel::isWhole() const
{
  return QFontMetrics(font()).horizontalAdvance(text()) <= width();
}

void ElidedLabel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setFont(font());
  painter.setPen(textColor);
  painter.drawText(rect(), int(alignment()),
                   QFontMetrics(font()).elidedText(text(), Qt::ElideRight, width()));
}

bool ElidedLabel::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip) setToolTip(isWhole() ? QString() : text());
  return QLabel::event(event);
}

}  // namespace perilymph::gui
