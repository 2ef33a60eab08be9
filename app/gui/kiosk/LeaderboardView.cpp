// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/LeaderboardView.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 360;

QLabel* label(const QString& text, int size_px, bool isQuiet, QWidget* parent)
{
  auto* made = new QLabel(text, parent);
  made->setFont(typeface(size_px));
  made->setProperty("quiet", isQuiet);
  return made;
}

}  // namespace

LeaderboardView::LeaderboardView(QWidget* parent)
    : QWidget(parent), column_(new QVBoxLayout(this)), source_(label({}, 13, true, this))
{
  setObjectName(QStringLiteral("boardView"));
  setFixedWidth(width_px);
  column_->setContentsMargins(3 * spacing, 3 * spacing, 3 * spacing, 2 * spacing);
  column_->setSpacing(spacing);
  auto* title = label(tr("Lowest peak forces today"), 22, false, this);
  title->setFont(typeface(22, QFont::DemiBold));
  title->setWordWrap(true);
  auto* note = label(tr("peak insertion force at full depth"), 15, true, this);
  note->setWordWrap(true);
  column_->addWidget(title);
  column_->addWidget(note);
  column_->addStretch();
  source_->setWordWrap(true);
  column_->addWidget(source_);
}

void LeaderboardView::setSource(const QString& source) { source_->setText(source); }

void LeaderboardView::show(const std::vector<KioskEntry>& entries, const QStringList& caption,
                           std::optional<int> chosen)
{
  delete rows_;
  rows_ = new QWidget(this);
  auto* rows = new QVBoxLayout(rows_);
  rows->setContentsMargins(0, spacing, 0, 0);
  rows->setSpacing(4);
  if (entries.empty()) {
    auto* empty =
        label(tr("No insertion has reached full depth yet. Be the first."), 17, false, rows_);
    empty->setWordWrap(true);
    rows->addWidget(empty);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const int rank = int(i) + 1;
    addRow(rank, entries[i], caption.value(int(i)), chosen == rank);
  }
  column_->insertWidget(2, rows_);
  rows_->QWidget::show();
}

void LeaderboardView::addRow(int rank, const KioskEntry& entry, const QString& caption,
                             bool isChosen)
{
  auto* row = new QWidget(rows_);
  row->setProperty("chosen", isChosen);
  auto* grid = new QGridLayout(row);
  grid->setContentsMargins(spacing, 4, spacing, 4);
  grid->setHorizontalSpacing(2 * spacing);
  grid->setVerticalSpacing(0);
  auto* place = label(QString::number(rank), 20, true, row);
  auto* peak = label(tr("%1 mN").arg(numberText(entry.peak_mN, 0)), 20, false, row);
  peak->setFont(typeface(20, isChosen ? QFont::DemiBold : QFont::Normal));
  auto* when =
      label(isChosen ? tr("you") : entry.at.toString(QStringLiteral("HH:mm")), 15, !isChosen, row);
  when->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(place, 0, 0);
  grid->addWidget(peak, 0, 1);
  grid->addWidget(when, 0, 2);
  if (!caption.isEmpty()) grid->addWidget(label(caption, 13, true, row), 1, 1, 1, 2);
  grid->setColumnMinimumWidth(0, 20);
  grid->setColumnStretch(2, 1);
  rows_->layout()->addWidget(row);
}

}  // namespace perilymph::gui
