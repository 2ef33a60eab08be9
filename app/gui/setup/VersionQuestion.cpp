// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/VersionQuestion.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <utility>

#include "gui/setup/MeasureVersions.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

VersionQuestion::VersionQuestion(QWidget* parent, const QString& place)
    : QWidget(parent),
      isNarrow_(!place.isEmpty()),
      title_(new WrappedLabel({}, this)),
      doubts_(new WrappedLabel({}, this)),
      table_(new QWidget(this))
{
  setObjectName(place + QLatin1String("versionQuestion"));
  title_->setObjectName(place + QLatin1String("versionTitle"));
  title_->setFont(typeface(13, QFont::DemiBold));
  doubts_->setObjectName(place + QLatin1String("codeDoubts"));
  doubts_->setFont(typeface(12));
  doubts_->setProperty("error", true);
  auto* table = new QGridLayout(table_);
  table->setContentsMargins(0, 0, 0, 0);
  table->setVerticalSpacing(2);
  const std::array heads{tr("saved, mm"), tr("new, mm"), tr("difference, mm")};
  const auto names = comparedNames();
  constexpr std::array keys{"A", "B", "H", "Cdl"};
  if (isNarrow_)
    table->setHorizontalSpacing(4);
  else
    table->addWidget(panelHeading(tr("± 95 %"), this), 0, 0);
  for (std::size_t k = 0; k < heads.size(); ++k)
    table->addWidget(panelHeading(heads[k], this), 0, int(k) + 1);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    auto* name = new QLabel(names[row], this);
    name->setFont(typeface(12));
    table->addWidget(name, int(row) + 1, 0);
    constexpr std::array columns{"saved", "new", "difference"};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      auto* cell = new QLabel(this);
      cell->setFont(typeface(12));
      cell->setObjectName(place + QLatin1String(columns[k]) + QLatin1String(keys[row]));
      table->addWidget(cell, int(row) + 1, int(k) + 1);
      cells_[row][k] = cell;
    }
  }
  accept_ = rowButton({}, "", this);
  accept_->setObjectName(place + QLatin1String("newVersionButton"));
  auto* refuse = rowButton(tr("Other code"), "", this);
  refuse->setObjectName(place + QLatin1String("otherCodeButton"));
  accept_->setProperty("primary", true);
  auto* buttons = new QBoxLayout(isNarrow_ ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  buttons->addWidget(accept_);
  buttons->addWidget(refuse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(title_);
  column->addWidget(doubts_);
  column->addWidget(table_);
  column->addLayout(buttons);
  connect(accept_, &QPushButton::clicked, this, [this] {
    const auto then = std::exchange(then_, {});
    drop();
    if (then) then();
  });
  connect(refuse, &QPushButton::clicked, this, [this] {
    drop();
    Q_EMIT otherCodeWanted();
  });
  drop();
}

void VersionQuestion::ask(const std::optional<SavedPatient>& saved,
                          const anatomy::Patient& measured, const QStringList& doubts,
                          std::function<void()> then)
{
  then_ = std::move(then);
  title_->setVisible(saved.has_value());
  table_->setVisible(saved.has_value());
  doubts_->setVisible(!doubts.isEmpty());
  doubts_->setText(doubts.join(QLatin1Char('\n')));
  accept_->setText(saved ? tr("New version") : tr("Use this code"));
  if (saved) compare(*saved, measured);
  show();
}

void VersionQuestion::compare(const SavedPatient& saved, const anatomy::Patient& measured)
{
  const QString code = QString::fromStdString(saved.patient.label);
  const QString side = saved.patient.side == anatomy::Side::left ? tr("left") : tr("right");
  const auto& versions = saved.record.versions;
  title_->setText(
      versions.empty()
          ? tr("%1 %2 exists.").arg(code, side)
          : tr("%1 %2 exists, saved %3.")
                .arg(code, side, QString::fromStdString(versions.back().savedUtc).left(10)));
  const ComparedMeasures before = comparedOf(saved.patient), after = comparedOf(measured);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    const auto shown = [&](const std::optional<ComparedMeasure>& measure) {
      const QString text = comparedText(measure, row);
      return isNarrow_ ? text.section(QLatin1Char(' '), 0, 0) : text;
    };
    cells_[row][0]->setText(shown(before[row]));
    cells_[row][1]->setText(shown(after[row]));
    const MeasureDifference difference = differenceOf(before[row], after[row], row);
    cells_[row][2]->setText(difference.text);
    cells_[row][2]->setStyleSheet(
        difference.isBeyond ? QStringLiteral("color: %1;").arg(shownTheme().warning.name())
                            : QString());
    cells_[row][2]->setToolTip(difference.detail);
  }
}

void VersionQuestion::drop()
{
  then_ = {};
  hide();
}

}  // namespace perilymph::gui
