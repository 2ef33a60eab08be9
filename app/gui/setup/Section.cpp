// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/Section.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int nameWidth_px = 76;

}  // namespace

Section::Section(const QString& title, const char* name, QWidget* parent)
    : QWidget(parent),
      title_(title.toUpper()),
      head_(new QPushButton(this)),
      note_(new QLabel(this)),
      body_(new QWidget(this)),
      rows_(new QVBoxLayout(body_))
{
  head_->setObjectName(QLatin1String(name));
  head_->setProperty("fold", true);
  head_->setFont(typeface(11, QFont::DemiBold));
  head_->setFixedHeight(sized(20));
  head_->setFocusPolicy(Qt::NoFocus);
  head_->setCheckable(true);
  head_->setChecked(true);
  head_->setToolTip(tr("Collapse or expand"));
  note_->setFont(typeface(11));
  note_->setProperty("quiet", true);

  auto* line = new QFrame(this);
  line->setObjectName(QStringLiteral("line"));
  line->setFixedHeight(1);
  auto* titleRow = new QHBoxLayout;
  titleRow->setSpacing(spacing);
  titleRow->addWidget(head_);
  titleRow->addStretch();
  titleRow->addWidget(note_);
  rows_->setContentsMargins(0, 2, 0, 0);
  rows_->setSpacing(4);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(line);
  column->addSpacing(2);
  column->addLayout(titleRow);
  column->addWidget(body_);
  connect(head_, &QPushButton::toggled, this, [this](bool isOpen) { setFolded(!isOpen); });
  setFolded(false);
}

void Section::setNote(const QString& note, const QString& tip)
{
  note_->setText(note);
  note_->setToolTip(tip);
}

void Section::setFolded(bool isFolded)
{
  const QString mark = isFolded ? QStringLiteral("▸ ") : QStringLiteral("▾ ");
  head_->setText(mark + title_);
  head_->setChecked(!isFolded);
  body_->setVisible(!isFolded);
}

bool Section::isFolded() const { return !head_->isChecked(); }

QWidget* namedRow(const QString& name, QWidget* control, QWidget* parent)
{
  auto* row = new QWidget(parent);
  auto* label = new QLabel(name, row);
  label->setFont(typeface(13));
  label->setMinimumWidth(sized(nameWidth_px));
  control->setParent(row);
  row->setToolTip(control->accessibleDescription());
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  layout->addWidget(label);
  layout->addWidget(control, 1);
  return row;
}

}  // namespace perilymph::gui
