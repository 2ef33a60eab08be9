// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/VersionQuestion.h"

#include <QGridLayout>
#include <QHBoxLayout>
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

VersionQuestion::VersionQuestion(QWidget* parent)
    : QWidget(parent), title_(new WrappedLabel({}, this))
{
  setObjectName(QStringLiteral("versionQuestion"));
  title_->setObjectName(QStringLiteral("versionTitle"));
  title_->setFont(typeface(13, QFont::DemiBold));
  auto* table = new QGridLayout;
  table->setVerticalSpacing(2);
  const std::array heads{tr("saved"), tr("new"), tr("difference")};
  const auto names = comparedNames();
  constexpr std::array keys{"A", "B", "H", "Cdl"};
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
      cell->setObjectName(QLatin1String(columns[k]) + QLatin1String(keys[row]));
      table->addWidget(cell, int(row) + 1, int(k) + 1);
      cells_[row][k] = cell;
    }
  }
  auto* accept = rowButton(tr("New version"), "newVersionButton", this);
  auto* refuse = rowButton(tr("Other code"), "otherCodeButton", this);
  accept->setProperty("primary", true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(accept);
  buttons->addWidget(refuse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(title_);
  column->addLayout(table);
  column->addLayout(buttons);
  connect(accept, &QPushButton::clicked, this, [this] {
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

void VersionQuestion::ask(const SavedPatient& saved, const anatomy::Patient& measured,
                          std::function<void()> then)
{
  then_ = std::move(then);
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
    cells_[row][0]->setText(comparedText(before[row], row));
    cells_[row][1]->setText(comparedText(after[row], row));
    const MeasureDifference difference = differenceOf(before[row], after[row], row);
    cells_[row][2]->setText(difference.text);
    cells_[row][2]->setStyleSheet(
        difference.isBeyond ? QStringLiteral("color: %1;").arg(shownTheme().warning.name())
                            : QString());
    cells_[row][2]->setToolTip(difference.detail);
  }
  show();
}

void VersionQuestion::drop()
{
  then_ = {};
  hide();
}

}  // namespace perilymph::gui
