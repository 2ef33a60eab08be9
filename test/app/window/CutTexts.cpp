// SPDX-License-Identifier: BSD-3-Clause
#include "CutTexts.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QFontMetrics>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <algorithm>

#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/ReadOut.h"
#include "gui/widgets/Selector.h"

namespace perilymph::test {

namespace {

int widthOf(const QWidget& widget, const QString& text)
{
  return QFontMetrics(widget.font()).horizontalAdvance(text);
}

int widestWord(const QLabel& label)
{
  int widest = 0;
  for (const QString& word : label.text().split(QRegularExpression("\\s+")))
    widest = std::max(widest, widthOf(label, word));
  return widest;
}

/// Whether a label shows its whole text, in one line or in the lines that fit its height.
bool isWhole(const QLabel& label)
{
  if (const auto* elided = qobject_cast<const gui::ElidedLabel*>(&label))
    return elided->minimumSizeHint().width() <= elided->width();
  if (label.width() >= label.sizeHint().width() && label.height() >= label.sizeHint().height())
    return true;
  return label.wordWrap() && label.height() >= label.heightForWidth(label.width()) &&
         label.width() >= widestWord(label);
}

bool isWhole(const QAbstractButton& button)
{
  if (button.hasHeightForWidth())
    return button.width() >= button.minimumSizeHint().width() &&
           button.height() >= button.heightForWidth(button.width());
  QStyleOptionButton option;
  option.initFrom(&button);
  const QRect inside =
      qobject_cast<const QPushButton*>(&button) != nullptr
          ? button.style()->subElementRect(QStyle::SE_PushButtonContents, &option, &button)
          : button.rect();
  const QFontMetrics metrics(button.font());
  const QStringList lines = button.text().split(QLatin1Char('\n'));
  const bool isWide = std::all_of(lines.begin(), lines.end(), [&](const QString& line) {
    return inside.width() >= widthOf(button, line);
  });
  return isWide &&
         button.height() >= metrics.height() + (int(lines.size()) - 1) * metrics.lineSpacing();
}

bool isWhole(const QComboBox& box)
{
  if (const auto* selector = qobject_cast<const gui::Selector*>(&box))
    return selector->isWhole() || !selector->toolTip().isEmpty();
  QStyleOptionComboBox option;
  option.initFrom(&box);
  const QRect inside =
      box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
  return inside.width() >= widthOf(box, box.currentText());
}

/// Whether a widget lies within all widgets around it; below a scroll area only its width counts.
bool isUncovered(const QWidget& widget)
{
  bool isScrolled = false;
  for (const QWidget* around = widget.parentWidget(); around != nullptr;
       around = around->parentWidget()) {
    const QRect place(widget.mapTo(around, QPoint(0, 0)), widget.size());
    if (place.left() < 0 || place.right() >= around->width()) return false;
    isScrolled = isScrolled || qobject_cast<const QAbstractScrollArea*>(around->parentWidget());
    if (!isScrolled && (place.top() < 0 || place.bottom() >= around->height())) return false;
    if (around->isWindow()) break;
  }
  return true;
}

}  // namespace

std::vector<std::string> cutTextsOf(const QWidget& window)
{
  std::vector<std::string> cut;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    QString text;
    bool isWholeText = true;
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      text = label->text();
      // the status line ends in an ellipsis and has a tooltip
      isWholeText = label->objectName() == "statusLabel" || isWhole(*label);
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      text = button->text();
      isWholeText = isWhole(*button);
    } else if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
      text = box->currentText();
      isWholeText = isWhole(*box);
    } else if (const auto* number = qobject_cast<const gui::ReadOut*>(widget)) {
      text = number->caption();
      isWholeText = number->width() >= number->sizeHint().width();
    }
    if (text.isEmpty() || (isWholeText && isUncovered(*widget))) continue;
    cut.push_back(widget->objectName().toStdString() + " \"" + text.toStdString() + "\" in " +
                  std::to_string(widget->width()) + " x " + std::to_string(widget->height()) +
                  (isWholeText ? ", partly covered" : ""));
  }
  return cut;
}

}  // namespace perilymph::test
