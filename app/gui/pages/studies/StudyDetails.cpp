// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyDetails.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/studies/StudyText.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int detailsWidth_px = 264;

}  // namespace

StudyDetails::StudyDetails(QWidget* parent)
    : QWidget(parent),
      hint_(
          new WrappedLabel(tr("Click a point to see its insertion. With the keyboard: arrow keys, "
                              "Home for the lowest and End for the highest value."),
                           this)),
      list_(new QWidget(this)),
      grid_(new QGridLayout(list_)),
      replay_(new QPushButton(tr("Replay this insertion"), this))
{
  setFixedWidth(sized(detailsWidth_px));
  hint_->setFont(typeface(13));
  hint_->setProperty("quiet", true);
  grid_->setContentsMargins(0, 0, spacing, 0);
  grid_->setHorizontalSpacing(spacing);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(0, 3);
  grid_->setColumnStretch(1, 2);
  replay_->setObjectName(QStringLiteral("replayStudyButton"));
  replay_->setProperty("primary", true);
  replay_->setFont(typeface(13, QFont::Medium));
  replay_->setFixedHeight(sized(32));
  replay_->setFocusPolicy(Qt::TabFocus);
  replay_->setToolTip(
      tr("Runs it again, as the study, its seed and its number say, and replays it (Enter)"));
  auto* inside = new QWidget(this);
  auto* stack = new QVBoxLayout(inside);
  stack->setContentsMargins(0, 0, 0, 0);
  stack->addWidget(hint_);
  stack->addWidget(list_);
  stack->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  column->addWidget(verticalScroll(inside, this), 1);
  column->addWidget(replay_);
  connect(replay_, &QPushButton::clicked, this, &StudyDetails::replayRequested);
  showNone();
}

void StudyDetails::clear()
{
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

void StudyDetails::show(const study::StudyResult& result)
{
  clear();
  isShown_ = true;
  hint_->hide();
  int row = 0;
  for (const auto& [name, value] : valuesOf(result)) {
    auto* nameLabel = new WrappedLabel(name, list_);
    auto* valueLabel = new WrappedLabel(value, list_);
    nameLabel->setFont(typeface(12));
    nameLabel->setProperty("quiet", true);
    valueLabel->setFont(typeface(12, QFont::Medium));
    valueLabel->setAlignment(Qt::AlignRight | Qt::AlignTop);
    valueLabel->setTextFormat(Qt::PlainText);
    grid_->addWidget(nameLabel, row, 0);
    grid_->addWidget(valueLabel, row, 1);
    ++row;
  }
  setBusy(isBusy_);
}

void StudyDetails::showNone()
{
  clear();
  isShown_ = false;
  hint_->show();
  setBusy(isBusy_);
}

void StudyDetails::setBusy(bool isBusy)
{
  isBusy_ = isBusy;
  replay_->setEnabled(isShown_ && !isBusy_);
}

}  // namespace perilymph::gui
