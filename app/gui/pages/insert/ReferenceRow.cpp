// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ReferenceRow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

ReferenceRow::ReferenceRow(QWidget* parent)
    : QWidget(parent),
      name_(new QLabel(this)),
      warning_(new QLabel(this)),
      remove_(new QPushButton(tr("Remove"), this))
{
  name_->setObjectName(QStringLiteral("referenceName"));
  name_->setFont(typeface(13));
  name_->setWordWrap(true);
  warning_->setObjectName(QStringLiteral("referenceWarning"));
  warning_->setFont(typeface(11));
  warning_->setWordWrap(true);
  warning_->setProperty("error", true);
  remove_->setObjectName(QStringLiteral("removeReferenceButton"));
  remove_->setProperty("small", true);
  remove_->setFont(typeface(11));
  remove_->setFixedHeight(sized(22));
  remove_->setFocusPolicy(Qt::TabFocus);
  remove_->setToolTip(tr("Removes the reference from chart and 3D view."));
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  row->addWidget(name_, 1);
  row->addWidget(remove_, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(2);
  column->addLayout(row);
  column->addWidget(warning_);
  connect(remove_, &QPushButton::clicked, this, &ReferenceRow::removeRequested);
  showState();
}

void ReferenceRow::setReference(const std::optional<ReferenceInsertion>& reference)
{
  reference_ = reference;
  showState();
}

void ReferenceRow::showCurrent(const session::ScenarioSubject& current)
{
  current_ = current;
  showState();
}

void ReferenceRow::showState()
{
  setVisible(reference_.has_value());
  if (!reference_) return;
  name_->setText(tr("Reference: %1").arg(reference_->name));
  const QString difference = differenceText(*reference_, current_);
  const bool isElsewhere = reference_->subject.cochlea != current_.cochlea;
  warning_->setText(isElsewhere
                        ? tr("It has %1. Its array is not shown in the 3D view.").arg(difference)
                        : tr("It has %1.").arg(difference));
  warning_->setVisible(!difference.isEmpty());
}

}  // namespace perilymph::gui
