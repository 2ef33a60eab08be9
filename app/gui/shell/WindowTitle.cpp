// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowTitle.h"

#include <QCoreApplication>

#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/ReplayControl.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

namespace {

QString titleOf(const session::Scenario& scenario)
{
  return QString::fromStdString(scenario.title().empty() ? scenario.name() : scenario.title());
}

}  // namespace

QString currentWork(const InsertPage& insertion)
{
  const SetupHistory& setup = insertion.setup();
  const bool isUsed = insertion.control().isRunning() || setup.isModified() ||
                      setup.origin().kind == SetupOrigin::Kind::own;
  return isUsed ? titleOf(insertion.control().scenario()) : QString();
}

QString windowTitleOf(const InsertPage& insertion)
{
  const ReplayControl& replay = insertion.replay();
  if (!replay.isOpen())
    return QCoreApplication::translate("perilymph::gui", "%1 — Perilymph")
        .arg(titleOf(insertion.control().scenario()));
  return QCoreApplication::translate("perilymph::gui", "Replay of %1 — Perilymph")
      .arg(QString::fromStdString(session::displayNameOf(replay.playback().file())));
}

}  // namespace perilymph::gui
