// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/ReadOut.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int unitGap_px = 8;
constexpr int compactSize_px = 26;
// Padding of the plate around number and caption.
constexpr int plate_px = 6;

QString dashed(const QString& number) { return number.isEmpty() ? QStringLiteral("–") : number; }

}  // namespace

ReadOut::ReadOut(Form form, QWidget* parent)
    : QWidget(parent), form_(std::move(form)), captionFont_(typeface(12))
{
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  setSize(form_.size_px);
}

void ReadOut::setSize(int size_px)
{
  numberFont_ = typeface(size_px, size_px > 30 ? QFont::Light : QFont::Normal);
  unitFont_ = typeface(std::max(13, size_px * 2 / 5), QFont::Normal);
  digitWidth_ = 0;
  const QFontMetrics metrics(numberFont_);
  for (char digit = '0'; digit <= '9'; ++digit)
    digitWidth_ = std::max(digitWidth_, metrics.horizontalAdvance(QLatin1Char(digit)));
}

void ReadOut::setCompact(bool isCompact)
{
  if (isCompact == isCompact_) return;
  isCompact_ = isCompact;
  fit();
}

void ReadOut::setNumberSize(int size_px)
{
  if (size_px == form_.size_px) return;
  form_.size_px = size_px;
  fit();
}

void ReadOut::fit()
{
  setSize(isCompact_ ? std::min(compactSize_px, form_.size_px) : form_.size_px);
  updateGeometry();
  update();
}

void ReadOut::setNumber(const QString& number)
{
  if (number == number_) return;
  number_ = number;
  setAccessibleName(number_ + QLatin1Char(' ') + form_.unit + QLatin1Char(' ') + caption_);
  update();
}

void ReadOut::setCaption(const QString& caption)
{
  if (caption == caption_) return;
  caption_ = caption;
  updateGeometry();
  update();
}

QSize ReadOut::sizeHint() const
{
  const int unit =
      form_.unit.isEmpty() ? 0 : unitGap_px + QFontMetrics(unitFont_).horizontalAdvance(form_.unit);
  const int caption =
      shownCaption().isEmpty() ? 0 : QFontMetrics(captionFont_).horizontalAdvance(shownCaption());
  const int captionHeight = shownCaption().isEmpty() ? 0 : QFontMetrics(captionFont_).height() + 2;
  return {std::max(numberWidth(form_.widest) + unit, caption) + 2 + 2 * plate_px,
          QFontMetrics(numberFont_).capHeight() + spacing + captionHeight + 2 * plate_px};
}

int ReadOut::cellWidth(QChar character) const
{
  return character.isDigit() ? digitWidth_ : QFontMetrics(numberFont_).horizontalAdvance(character);
}

int ReadOut::numberWidth(const QString& number) const
{
  int width = 0;
  for (const QChar character : number) width += cellWidth(character);
  return width;
}

void ReadOut::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  const QString number = dashed(number_);
  const QFontMetrics unitMetrics(unitFont_);
  const int unitWidth =
      form_.unit.isEmpty() ? 0 : unitGap_px + unitMetrics.horizontalAdvance(form_.unit);
  const int baseline = QFontMetrics(numberFont_).capHeight() + plate_px;
  const bool isRight = (form_.side & Qt::AlignRight) != 0;
  const int left = plate_px, right = width() - plate_px;

  // The plate keeps the number legible when the array is behind it.
  paintPlate(painter, rect());

  int x = isRight ? right - unitWidth - numberWidth(number) : left;
  painter.setFont(numberFont_);
  painter.setPen(shownTheme().text);
  for (const QChar character : number) {
    const int cell = cellWidth(character);
    const int inCell = QFontMetrics(numberFont_).horizontalAdvance(character);
    painter.drawText(x + (cell - inCell) / 2, baseline, QString(character));
    x += cell;
  }
  painter.setFont(unitFont_);
  painter.setPen(shownTheme().quietText);
  const int unitX = isRight ? right - unitWidth : left + numberWidth(number);
  painter.drawText(unitX + unitGap_px, baseline, form_.unit);

  if (shownCaption().isEmpty()) return;
  painter.setFont(captionFont_);
  const QFontMetrics metrics(captionFont_);
  const int captionX = isRight ? right - metrics.horizontalAdvance(shownCaption()) : left;
  painter.drawText(captionX, baseline + spacing + metrics.ascent() + 2, shownCaption());
}

int widthOf(std::initializer_list<const ReadOut*> row)
{
  int width = 5 * spacing;
  for (const ReadOut* each : row) width += each->sizeHint().width();
  return width;
}

}  // namespace perilymph::gui
