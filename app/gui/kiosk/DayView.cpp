// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/DayView.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <utility>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double lineOverLetter = 1.4;  // height of a row over the size of its type
constexpr int numberRows = 4;           // title, visitors, best, median

QLabel* label(const QString& text, const QFont& font, bool isQuiet, QWidget* parent)
{
  auto* made = new QLabel(text, parent);
  made->setFont(font);
  made->setProperty("quiet", isQuiet);
  return made;
}

}  // namespace

DayView::DayView(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this))
{
  setObjectName(QStringLiteral("dayView"));
  // its rows follow its height, not the other way
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
}

void DayView::setRange(std::optional<analysis::PrintedRange> measured)
{
  measured_ = std::move(measured);
  fill();
}

void DayView::setLetterSize(int size_px)
{
  letter_px_ = size_px;
  fill();
}

void DayView::show(Content content)
{
  content_ = std::move(content);
  fill();
}

void DayView::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  if (event->size().height() == event->oldSize().height()) return;
  // later: the rows, which are replaced, may be those whose layout is being computed
  QMetaObject::invokeMethod(this, &DayView::fill, Qt::QueuedConnection);
}

int DayView::rowHeight() const { return qRound(lineOverLetter * sized(letter_px_)); }

QString DayView::forceText(double peak_mN) const
{
  const QString number = tr("%1 mN").arg(numberText(peak_mN, 0));
  if (!measured_) return number;
  return signOf(levelOf(millinewtons(peak_mN).si(), *measured_)) + QLatin1Char(' ') + number;
}

void DayView::fill()
{
  delete rows_;
  rows_ = new QWidget(this);
  auto* rows = new QVBoxLayout(rows_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  auto* title = label(tr("Today"), typeface(letter_px_, QFont::DemiBold), false, rows_);
  title->setFixedHeight(rowHeight());
  rows->addWidget(title);
  const DayStatistics& day = content_.statistics;
  addNumber(tr("Visitors"), QString::number(day.visitors));
  if (day.best_mN && day.median_mN) {
    addNumber(tr("Best"), forceText(*day.best_mN));
    addNumber(tr("Median"), forceText(*day.median_mN));
  }
  const int room = height() / std::max(1, rowHeight()) - numberRows - 1;
  const int count = std::min(room, static_cast<int>(content_.best.size()));
  if (count > 0) {
    auto* best = label(tr("Gentlest"), typeface(letter_px_, QFont::DemiBold), false, rows_);
    best->setFixedHeight(rowHeight());
    rows->addWidget(best);
  }
  for (int rank = 1; rank <= count; ++rank) {
    // the last line is the visitor's, if it is not among those above
    const bool isOwn = rank == count && content_.chosen.value_or(0) > count;
    const int shown = isOwn ? *content_.chosen : rank;
    addRow(shown, content_.best[static_cast<std::size_t>(shown - 1)], content_.chosen == shown);
  }
  rows->addStretch();
  column_->addWidget(rows_);
  rows_->QWidget::show();
}

void DayView::addNumber(const QString& caption, const QString& number)
{
  auto* row = new QWidget(rows_);
  row->setFixedHeight(rowHeight());
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(label(caption, typeface(letter_px_), true, row));
  line->addStretch();
  line->addWidget(label(number, typeface(letter_px_), false, row));
  rows_->layout()->addWidget(row);
}

void DayView::addRow(int rank, const KioskEntry& entry, bool isChosen)
{
  auto* row = new QWidget(rows_);
  row->setFixedHeight(rowHeight());
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  const QFont font = typeface(letter_px_, isChosen ? QFont::DemiBold : QFont::Normal);
  line->addWidget(label(tr("%1.").arg(rank), font, !isChosen, row));
  line->addWidget(label(forceText(entry.peak_mN), font, false, row));
  line->addStretch();
  const QString when = isChosen ? tr("you") : entry.at.toString(QStringLiteral("HH:mm"));
  line->addWidget(label(when, font, !isChosen, row));
  rows_->layout()->addWidget(row);
}

}  // namespace perilymph::gui
