// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/CheckBoxes.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "gui/widgets/FocusRing.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int mark_px = 14;
constexpr int rowHeight_px = 24;
constexpr int ringGap_px = 6;  ///< Between text and the edge of its focus ring.

/// As large as the text, which shrinks on small screens.
int markSize() { return sized(mark_px); }

int textLeft() { return markSize() + 10; }

QSize rowSize(const QAbstractButton& button)
{
  const int text = QFontMetrics(button.font()).horizontalAdvance(button.text());
  return {textLeft() + text + ringGap_px, sized(rowHeight_px)};
}

QSize minSize(const QAbstractButton& button)
{
  int widest = 0;
  for (const QString& word : button.text().split(QLatin1Char(' ')))
    widest = std::max(widest, QFontMetrics(button.font()).horizontalAdvance(word));
  return {textLeft() + widest + ringGap_px, sized(rowHeight_px)};
}

int heightOf(const QAbstractButton& button, int width)
{
  const QFontMetrics metrics(button.font());
  const QRect available(0, 0, std::max(1, width - textLeft()), 1000);
  const int label = metrics.boundingRect(available, Qt::TextWordWrap, button.text()).height();
  return std::max(sized(rowHeight_px), label + sized(rowHeight_px) - metrics.height());
}

QRectF markPlace(const QWidget& widget)
{
  const int size = markSize();
  return {0.5, (widget.height() - size) / 2.0, double(size), double(size)};
}

void drawText(QPainter& painter, const QAbstractButton& button)
{
  painter.setPen(button.isEnabled() ? shownTheme().text : shownTheme().quietText);
  painter.drawText(button.rect().adjusted(textLeft(), 0, 0, 0),
                   Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, button.text());
  if (!button.hasFocus()) return;
  const int width = QFontMetrics(button.font()).horizontalAdvance(button.text());
  const QRect label(textLeft() - ringGap_px, 0, width + 2 * ringGap_px, button.height());
  paintFocusRing(painter, label.intersected(button.rect()));
}

}  // namespace

CheckBox::CheckBox(const QString& text, QWidget* parent) : QCheckBox(text, parent)
{
  setFont(typeface(13));
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);  // higher if text is wrapped
}

QSize CheckBox::sizeHint() const { return rowSize(*this); }
QSize CheckBox::minimumSizeHint() const { return minSize(*this); }
int CheckBox::heightForWidth(int width) const { return heightOf(*this, width); }

void CheckBox::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF place = markPlace(*this);
  painter.setPen(QPen(isChecked() ? shownTheme().accent : shownTheme().quietText, 1.2));
  painter.setBrush(isChecked() ? QBrush(shownTheme().accent) : QBrush(Qt::NoBrush));
  painter.drawRoundedRect(place, 3, 3);
  if (isChecked()) {
    const double scale = place.width() / mark_px;
    QPainterPath tick(place.topLeft() + scale * QPointF(3.2, 7.2));
    tick.lineTo(place.topLeft() + scale * QPointF(6.0, 10.0));
    tick.lineTo(place.topLeft() + scale * QPointF(10.8, 4.4));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(shownTheme().ground, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(tick);
  }
  drawText(painter, *this);
}

Choice::Choice(const QString& text, QWidget* parent) : QRadioButton(text, parent)
{
  setFont(typeface(13));
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);  // higher if text is wrapped
}

QSize Choice::sizeHint() const { return rowSize(*this); }
QSize Choice::minimumSizeHint() const { return minSize(*this); }
int Choice::heightForWidth(int width) const { return heightOf(*this, width); }

void Choice::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF place = markPlace(*this);
  const QColor ring = isChecked() && isEnabled() ? shownTheme().accent : shownTheme().quietText;
  painter.setPen(QPen(ring, 1.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(place);
  if (isChecked()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ring);
    const double inset = 3.6 * place.width() / mark_px;
    painter.drawEllipse(place.adjusted(inset, inset, -inset, -inset));
  }
  drawText(painter, *this);
}

}  // namespace perilymph::gui
