// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/ReferenceInsertion.h"

#include <QCoreApplication>

namespace perilymph::gui {

QString differenceText(const ReferenceInsertion& reference, const session::ScenarioSubject& current)
{
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("perilymph::gui", text);
  };
  QStringList differences;
  if (reference.subject.array != current.array)
    differences << tr("another array (%1)").arg(QString::fromStdString(reference.subject.array));
  if (reference.subject.cochlea != current.cochlea)
    differences
        << tr("another cochlea (%1)").arg(QString::fromStdString(reference.subject.patient));
  return differences.join(QStringLiteral(", "));
}

}  // namespace perilymph::gui
