// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowTitle.h"

#include <QCoreApplication>

#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/setup/SetupTitle.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

QString windowTitleOf(const InsertionController& insertion)
{
  const ReplayPlayer& replay = insertion.replay();
  if (insertion.loading() != nullptr)
    return QCoreApplication::translate("perilymph::gui", "%1 — Perilymph")
        .arg(subjectText(*insertion.loading()));
  if (!replay.isOpen())
    return QCoreApplication::translate("perilymph::gui", "%1 — Perilymph")
        .arg(setupTitle(insertion.control(), insertion.history()));
  return QCoreApplication::translate("perilymph::gui", "Replay of %1 — Perilymph")
      .arg(QString::fromStdString(session::displayNameOf(replay.playback().file())));
}

}  // namespace perilymph::gui
