// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/SetupTitle.h"

#include <QCoreApplication>

#include "gui/setup/SetupHistory.h"
#include "gui/text/DataText.h"
#include "perilymph/anatomy/AnatomySource.h"

namespace perilymph::gui {

namespace {

QString scenarioTitle(const session::Scenario& scenario)
{
  return dataText(scenario.title().empty() ? scenario.name() : scenario.title());
}

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

QString subjectText(const session::Scenario& scenario)
{
  const anatomy::Patient& patient = scenario.patient();
  const QString ear = patient.side == anatomy::Side::left ? tr("left ear") : tr("right ear");
  const bool isPatient = isScaledBy(scenario.anatomy(), patient);
  if (isPatient && patient.label == "unnamed") return tr("Patient without a code · %1").arg(ear);
  const QString label = QString::fromStdString(patient.label);
  const QString simulated = QStringLiteral("Simulated cochlea ");  // of a study
  if (isPatient && label.startsWith(simulated))
    return tr("Simulated cochlea %1 · %2").arg(label.mid(simulated.size()), ear);
  if (isPatient && patient.label != "published") return tr("Patient %1 · %2").arg(label, ear);
  switch (scenario.anatomy()) {
    case anatomy::AnatomySource::published:
      return tr("Published cochlea · %1").arg(ear);
    case anatomy::AnatomySource::mean:
      return tr("Average cochlea · %1").arg(ear);
    case anatomy::AnatomySource::clark:
      break;
  }
  return tr("Clark’s spiral · %1").arg(ear);
}

QString shortSubjectText(const session::Scenario& scenario)
{
  const anatomy::Patient& patient = scenario.patient();
  const bool isPatient = isScaledBy(scenario.anatomy(), patient) && patient.label != "published" &&
                         patient.label != "unnamed";
  if (!isPatient) return subjectText(scenario);
  return tr("%1 · %2").arg(QString::fromStdString(patient.label),
                           patient.side == anatomy::Side::left ? tr("left") : tr("right"));
}

QString setupTitle(const InsertionControl& control, const SetupHistory& setup)
{
  if (!setup.isModified()) return scenarioTitle(control.scenario());
  return QCoreApplication::translate("perilymph::gui", "Modified (%1): %2")
      .arg(setup.changedText(), scenarioTitle(setup.origin().setup.scenario));
}

QString currentWork(const InsertionControl& control, const SetupHistory& setup)
{
  const bool isUsed =
      control.isRunning() || setup.isModified() || setup.origin().kind == SetupOrigin::Kind::own;
  return isUsed ? setupTitle(control, setup) : QString();
}

QString progressText(Progress progress)
{
  switch (progress) {
    case Progress::ready:
      return tr("ready");
    case Progress::underway:
      return tr("running");
    case Progress::resting:
      return tr("ended, resting");
    case Progress::concluded:
      break;
  }
  return tr("ended");
}

QString recordingText(Progress progress)
{
  if (progress == Progress::underway) return tr("recording now");
  return progress == Progress::resting ? tr("recording the rest") : QString();
}

}  // namespace perilymph::gui
