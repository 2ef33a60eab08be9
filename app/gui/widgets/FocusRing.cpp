// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/FocusRing.h"

#include <QAbstractButton>
#include <QPainter>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

void paintFocusRing(QPainter& painter, const QRect& area)
{
  constexpr double outer_px = 2.0, inner_px = 1.5;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  constexpr double middle = outer_px + 0.5 * inner_px;
  painter.setPen(QPen(shownTheme().ground, inner_px));
  painter.drawRoundedRect(QRectF(area).adjusted(middle, middle, -middle, -middle), 3.5, 3.5);
  constexpr double edge = 0.5 * outer_px;
  painter.setPen(QPen(shownTheme().text, outer_px));
  painter.drawRoundedRect(QRectF(area).adjusted(edge, edge, -edge, -edge), 4.5, 4.5);
}

FocusRingStyle::FocusRingStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void FocusRingStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                   QPainter* painter, const QWidget* widget) const
{
  if (element != PE_FrameFocusRect || qobject_cast<const QAbstractButton*>(widget) == nullptr)
    return QProxyStyle::drawPrimitive(element, option, painter, widget);
  painter->save();
  paintFocusRing(*painter, widget->rect());
  painter->restore();
}

}  // namespace perilymph::gui
