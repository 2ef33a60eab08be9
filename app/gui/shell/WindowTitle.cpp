// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowTitle.h"

#include <QCoreApplication>

#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/ReplayControl.h"
#include "gui/parts/DataText.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

namespace {

QString titleOf(const session::Scenario& scenario)
{
  return dataText(scenario.title().empty() ? scenario.name() : scenario.title());
}

/// The title of the insertion; that of a modified preset is put together in the window's language.
QString titleOf(const InsertPage& insertion)
{
  const SetupHistory& setup = insertion.setup();
  if (!setup.isModified()) return titleOf(insertion.control().scenario());
  return QCoreApplication::translate("perilymph::gui", "Modified (%1): %2")
      .arg(setup.changedText(), titleOf(setup.origin().setup.scenario));
}

}  // namespace

QString currentWork(const InsertPage& insertion)
{
  const SetupHistory& setup = insertion.setup();
  const bool isUsed = insertion.control().isRunning() || setup.isModified() ||
                      setup.origin().kind == SetupOrigin::Kind::own;
  return isUsed ? titleOf(insertion) : QString();
}

QString windowTitleOf(const InsertPage& insertion)
{
  const ReplayControl& replay = insertion.replay();
  if (!replay.isOpen())
    return QCoreApplication::translate("perilymph::gui", "%1 — Perilymph").arg(titleOf(insertion));
  return QCoreApplication::translate("perilymph::gui", "Replay of %1 — Perilymph")
      .arg(QString::fromStdString(session::displayNameOf(replay.playback().file())));
}

}  // namespace perilymph::gui
