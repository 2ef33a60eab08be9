// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/SetupTitle.h"

#include <QCoreApplication>

#include "gui/run/InsertionControl.h"
#include "gui/setup/SetupHistory.h"
#include "gui/text/DataText.h"

namespace perilymph::gui {

namespace {

QString scenarioTitle(const session::Scenario& scenario)
{
  return dataText(scenario.title().empty() ? scenario.name() : scenario.title());
}

}  // namespace

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

}  // namespace perilymph::gui
