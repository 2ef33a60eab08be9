// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/Placeholder.h"

#include <QLineEdit>
#include <QStyle>
#include <QVariant>

namespace perilymph::gui {

void markPlaceholder(QLineEdit& field, const QString& hint)
{
  field.setPlaceholderText(hint);
  const auto show = [&field, weight = field.font().weight()] {
    const bool isEmpty = field.text().isEmpty();
    QFont font = field.font();
    if (font.italic() == isEmpty) return;
    font.setItalic(isEmpty);
    font.setWeight(QFont::Normal);
    if (!isEmpty) font.setWeight(weight);
    field.setFont(font);
    field.setProperty("hint", isEmpty);
    field.style()->unpolish(&field);
    field.style()->polish(&field);
  };
  QObject::connect(&field, &QLineEdit::textChanged, &field, show);
  show();
}

}  // namespace perilymph::gui
