#include "Pane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QVariant>

#include "Theme.h"

namespace perilymph::gui {

Pane::Pane(const QString& title, const QString& note, QWidget* content, QWidget* parent)
    : QWidget(parent), title_(new QLabel(title, this)), note_(new QLabel(note, this))
{
  title_->setFont(typeface(13, QFont::DemiBold));
  note_->setFont(typeface(11));
  note_->setProperty("quiet", true);
  auto* row = new QHBoxLayout;
  row->addWidget(title_);
  row->addStretch();
  row->addWidget(note_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, spacing, 2 * spacing, spacing);
  column->setSpacing(6);
  column->addLayout(row);
  column->addWidget(content, 1);
  content->setParent(this);
}

void Pane::setNote(const QString& note)
{
  if (note_->text() != note) note_->setText(note);
}

void Pane::setTip(const QString& tip) { title_->setToolTip(tip); }

void Pane::mouseDoubleClickEvent(QMouseEvent* event)
{
  event->accept();
  Q_EMIT maximizeAsked();
}

}  // namespace perilymph::gui
