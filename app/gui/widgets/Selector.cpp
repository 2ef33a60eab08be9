// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/Selector.h"

#include <QAbstractItemView>
#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>
#include <QStandardItemModel>
#include <QWheelEvent>
#include <algorithm>

#include "gui/widgets/FocusRing.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int height_px = 26;
constexpr int textMargin_px = 8;
constexpr int arrowWidth_px = 24;
constexpr int textRole = Qt::UserRole + 1;  // the text without a reason

QStandardItem* itemOf(const QComboBox& box, int index)
{
  const auto* items = qobject_cast<const QStandardItemModel*>(box.model());
  return items == nullptr ? nullptr : items->item(index);
}

}  // namespace

Selector::Selector(const char* name, const QString& accessibleName, QWidget* parent)
    : QComboBox(parent)
{
  setObjectName(QLatin1String(name));
  setAccessibleName(accessibleName);
  setFont(typeface(13));
  view()->setFont(typeface(13));
  setFixedHeight(sized(height_px));
  setFocusPolicy(Qt::TabFocus);
  setMaxVisibleItems(26);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(this, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { Q_EMIT chosen(itemData(index).toString()); });
}

void Selector::addHeading(const QString& text)
{
  addItem(text);
  if (QStandardItem* item = itemOf(*this, count() - 1)) {
    item->setEnabled(false);
    item->setFont(typeface(11, QFont::DemiBold));
    item->setForeground(shownTheme().quietText);
  }
}

void Selector::addChoice(const QString& text, const QString& value, const QString& tip)
{
  addItem(text, value);
  setItemData(count() - 1, text, textRole);
  setItemData(count() - 1, tip, Qt::ToolTipRole);
}

void Selector::setPossible(const QString& value, bool isPossible, const QString& reason)
{
  const int index = findData(value);
  QStandardItem* item = itemOf(*this, index);
  if (item == nullptr) return;
  item->setEnabled(isPossible);
  item->setForeground(isPossible ? shownTheme().text : shownTheme().quietText);
  const QString text = itemData(index, textRole).toString();
  setItemText(index, isPossible ? text : text + QStringLiteral(" – ") + reason);
}

bool Selector::isPossible(const QString& value) const
{
  const QStandardItem* item = itemOf(*this, findData(value));
  return item != nullptr && item->isEnabled();
}

void Selector::show(const QString& value, const QString& textIfMissing)
{
  if (findData(value) < 0) addChoice(textIfMissing, value);
  setCurrentIndex(findData(value));
  shown_.clear();
  setToolTip(itemData(currentIndex(), Qt::ToolTipRole).toString());
  update();
}

int Selector::widest_px() const
{
  int label = 0;
  for (int i = 0; i < count(); ++i)
    label = std::max(label, QFontMetrics(font()).horizontalAdvance(itemText(i)));
  return label + textMargin_px + arrowWidth_px + 1;
}

QString Selector::text() const
{
  if (!shown_.isEmpty()) return shown_;
  const QVariant own = itemData(currentIndex(), textRole);
  return own.isValid() ? own.toString() : currentText();
}

bool Selector::isWhole() const
{
  return QFontMetrics(font()).horizontalAdvance(text()) <= width() - textMargin_px - arrowWidth_px;
}

QSize Selector::sizeHint() const { return {120, sized(height_px)}; }

QSize Selector::minimumSizeHint() const { return {60, sized(height_px)}; }

void Selector::showPopup()
{
  int widest = width();
  for (int i = 0; i < count(); ++i) {
    const QFontMetrics metrics(view()->font());
    widest = std::max(widest, metrics.horizontalAdvance(itemText(i)) + 40);
  }
  view()->setMinimumWidth(widest);
  QComboBox::showPopup();
}

void Selector::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool isChosen = isEnabled() && underMouse();
  painter.setPen(QPen(isChosen      ? shownTheme().accent
                      : isEnabled() ? shownTheme().border
                                    : shownTheme().line,
                      1.0));
  painter.setBrush(isEnabled() ? shownTheme().ground : shownTheme().panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);

  painter.setPen(isEnabled() ? shownTheme().text : shownTheme().quietText);
  painter.setFont(font());
  const QRect place = rect().adjusted(textMargin_px, 0, -arrowWidth_px, 0);
  painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetrics(font()).elidedText(text(), Qt::ElideRight, place.width()));
  if (!isEnabled()) return;
  if (hasFocus()) paintFocusRing(painter, rect());
  QPainterPath arrow;
  const QPointF middle(width() - 13.0, height() / 2.0 + 1.0);
  arrow.moveTo(middle + QPointF(-4, -3));
  arrow.lineTo(middle + QPointF(4, -3));
  arrow.lineTo(middle + QPointF(0, 2.5));
  painter.fillPath(arrow, shownTheme().quietText);
}

void Selector::wheelEvent(QWheelEvent* event) { event->ignore(); }

}  // namespace perilymph::gui
