// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/TaskText.h"

#include <QCoreApplication>

namespace perilymph::gui {

QString taskText(const QString& task, double fraction, double elapsed_s)
{
  // earlier, the beginning says little of the rest
  constexpr double shortest_s = 1.0, minFraction = 0.05;
  if (elapsed_s < shortest_s || fraction < minFraction) return task;
  const double left_s = elapsed_s * (1.0 - fraction) / fraction;
  return QCoreApplication::translate("perilymph::gui", "%1 about %2 s left")
      .arg(task)
      .arg(qRound(left_s));
}

}  // namespace perilymph::gui
