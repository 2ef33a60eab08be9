// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/KeyList.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <utility>
#include <vector>

#include "gui/shell/KeyActions.h"
#include "gui/widgets/SheetScroll.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

// Two columns fit into the smallest window, 1024 x 640.
constexpr int meaningWidth_px = 230;

void addHeading(QGridLayout& grid, const QString& text, QWidget* parent)
{
  auto* heading = new QLabel(text, parent);
  heading->setFont(typeface(13, QFont::DemiBold));
  grid.addWidget(heading, grid.rowCount(), 0, 1, 2);
}

void addRow(QGridLayout& grid, const QString& keys, const QString& meaning, QWidget* parent)
{
  auto* keysLabel = new QLabel(keys, parent);
  keysLabel->setFont(typeface(12, QFont::Medium));
  auto* meaningLabel = new WrappedLabel(meaning, parent);
  meaningLabel->setFont(typeface(12));
  meaningLabel->setMinimumWidth(sized(meaningWidth_px));
  meaningLabel->setProperty("quiet", true);
  const int row = grid.rowCount();
  grid.addWidget(keysLabel, row, 0);
  grid.addWidget(meaningLabel, row, 1);
}

}  // namespace

KeyList::KeyList(const KeyActions& actions, QWidget* parent) : QFrame(parent)
{
  setObjectName(QStringLiteral("keys"));
  auto* guide = new QPushButton(tr("User guide"), this);
  guide->setObjectName(QStringLiteral("guideButton"));
  guide->setFont(typeface(13, QFont::Medium));
  guide->setFixedHeight(sized(28));
  guide->setFocusPolicy(Qt::TabFocus);
  guide->setToolTip(tr("Five tutorials and a search (Shift+F1)"));
  connect(guide, &QPushButton::clicked, this, &KeyList::guideRequested);
  auto* content = new QWidget(this);
  columns_ = new QBoxLayout(QBoxLayout::LeftToRight, content);
  columns_->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing);
  columns_->setSpacing(3 * spacing);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(1, 1, 1, 1);
  whole->addWidget(new SheetScroll(content, this));
  const std::vector<std::pair<KeySection, QString>> halves[] = {
      {{KeySection::insertion, tr("Insertion")},
       {KeySection::picture, tr("View")},
       {KeySection::ct, tr("CT")}},
      {{KeySection::replay, tr("Replay")}, {KeySection::window, tr("Window")}}};
  for (const auto& half : halves) {
    auto* column = new QVBoxLayout;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * spacing);
    grid->setVerticalSpacing(3);
    column->addLayout(grid);
    column->addStretch(1);
    columns_->addLayout(column);
    for (const auto& [section, title] : half) {
      addHeading(*grid, title, this);
      for (const KeyAction& action : actions.actions())
        if (action.section == section) addRow(*grid, keysText(action), action.meaning, this);
      for (const Gesture& gesture : actions.gestures())
        if (gesture.section == section) addRow(*grid, gesture.what, gesture.meaning, this);
    }
    if (&half == std::end(halves) - 1) column->addWidget(guide, 0, Qt::AlignRight);
  }
  hide();
}

void KeyList::fit()
{
  columns_->setDirection(QBoxLayout::LeftToRight);
  const bool isWide = columns_->sizeHint().width() + 6 * spacing > parentWidget()->width();
  if (isWide) columns_->setDirection(QBoxLayout::TopToBottom);
  fitSheet(*this);
}

}  // namespace perilymph::gui
