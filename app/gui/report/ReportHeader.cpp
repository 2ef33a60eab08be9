// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportHeader.h"

#include <QCoreApplication>

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

QString subjectOf(const ReportContent& content)
{
  const bool isLeft = content.scenario.patient().side == anatomy::Side::left;
  const QString ear = isLeft ? tr("left ear") : tr("right ear");
  if (!content.hasPatient()) return tr("No patient · %1").arg(ear);
  return tr("Patient %1 · %2").arg(QString::fromStdString(content.scenario.patient().label), ear);
}

}  // namespace perilymph::gui
