// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/BuildingNote.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

BuildingNote::BuildingNote(QWidget* page) : Overlay(page), text_(new QLabel(this))
{
  setObjectName(QStringLiteral("buildingNote"));
  text_->setObjectName(QStringLiteral("buildingText"));
  text_->setFont(typeface(13));
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName(QStringLiteral("cancelBuildButton"));
  cancel->setFont(typeface(13, QFont::Medium));
  cancel->setFixedHeight(sized(28));
  cancel->setFocusPolicy(Qt::TabFocus);
  cancel->setToolTip(tr("Keep the cochlea and array shown (Esc)"));
  connect(cancel, &QPushButton::clicked, this, &BuildingNote::cancelRequested);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * spacing, spacing, spacing, spacing);
  row->setSpacing(2 * spacing);
  row->addWidget(text_);
  row->addWidget(endlessBar(120, this));
  row->addWidget(cancel);
  hide();
}

void BuildingNote::show(qint64 busyFor_ms)
{
  const bool isWorthIt = busyFor_ms >= patience_ms;
  if (isWorthIt) text_->setText(tr("Building the cochlea… %1 s").arg(busyFor_ms / 1000));
  if (isWorthIt == !isHidden()) return;
  setVisible(isWorthIt);
  if (isWorthIt) place();
}

void BuildingNote::place()
{
  adjustSize();
  const QWidget& page = *parentWidget();
  move((page.width() - width()) / 2, page.height() / 2);
  raise();
}

}  // namespace perilymph::gui
