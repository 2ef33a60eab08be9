// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/ElidedLabel.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>
#include <algorithm>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {}

QSize ElidedLabel::minimumSizeHint() const
{
  const QSize whole = sizeHint();
  return {std::min(sized(64), whole.width()), whole.height()};
}

bool ElidedLabel::isWhole() const
{
  return QFontMetrics(font()).horizontalAdvance(text()) <= contentsRect().width();
}

void ElidedLabel::paintEvent(QPaintEvent*)
{
  QStyleOption option;
  option.initFrom(this);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_Widget, &option, &painter, this);
  const QRect inside = contentsRect();
  painter.setFont(font());
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(inside, int(alignment()),
                   QFontMetrics(font()).elidedText(text(), Qt::ElideRight, inside.width()));
}

bool ElidedLabel::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip) setToolTip(isWhole() ? QString() : text());
  return QLabel::event(event);
}

}  // namespace perilymph::gui
