// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/WrappedLabel.h"

#include <QResizeEvent>

namespace perilymph::gui {

WrappedLabel::WrappedLabel(const QString& text, QWidget* parent) : QLabel(text, parent)
{
  setWordWrap(true);
}

QSize WrappedLabel::minimumSizeHint() const
{
  const QSize usual = QLabel::minimumSizeHint();
  if (width() < usual.width()) return usual;  // not laid out yet
  return {usual.width(), heightForWidth(width())};
}

void WrappedLabel::resizeEvent(QResizeEvent* event)
{
  QLabel::resizeEvent(event);
  if (event->oldSize().width() != width()) updateGeometry();
}

}  // namespace perilymph::gui
