// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/Pane.h"

#include <QFontMetrics>
#include <QLabel>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

Pane::Pane(const QString& title, const QString& note, QWidget* content, QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(title, this)),
      note_(new QLabel(note, this)),
      head_(new QBoxLayout(QBoxLayout::LeftToRight))
{
  title_->setFont(typeface(13, QFont::DemiBold));
  note_->setFont(typeface(11));
  note_->setProperty("quiet", true);
  for (QLabel* label : {title_, note_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(1);
  }
  head_->addWidget(title_, 1);
  head_->addWidget(note_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing);
  column->setSpacing(6);
  column->addLayout(head_);
  column->addWidget(content, 1);
  content->setParent(this);
  placeNote();
}

void Pane::placeNote()
{
  const auto width = [](const QLabel* label) {
    return QFontMetrics(label->font()).horizontalAdvance(label->text());
  };
  const int available = this->width() - 4 * spacing;
  const bool isBeside = width(title_) + 2 * spacing + width(note_) <= available;
  head_->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  head_->setSpacing(isBeside ? spacing : 0);
  note_->setWordWrap(!isBeside);
  note_->setVisible(!note_->text().isEmpty());
}

void Pane::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  placeNote();
}

void Pane::setNote(const QString& note)
{
  if (note_->text() == note) return;
  note_->setText(note);
  placeNote();
}

void Pane::setTip(const QString& tip) { title_->setToolTip(tip); }

void Pane::mouseDoubleClickEvent(QMouseEvent* event)
{
  event->accept();
  Q_EMIT maximizeRequested();
}

}  // namespace perilymph::gui
