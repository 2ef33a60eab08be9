// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/WindowTitle.h"

#include <QCoreApplication>

#include "gui/pages/Page.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/setup/SetupTitle.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

QString windowTitleOf(const Page& page, const InsertionController& insertion)
{
  const auto title = [](const QString& subject) {
    return QCoreApplication::translate("perilymph::gui", "%1 — Perilymph").arg(subject);
  };
  const ReplayPlayer& replay = insertion.replay();
  if (!page.showsInsertion()) return title(page.name());
  if (insertion.loading() != nullptr) return title(subjectText(*insertion.loading()));
  if (!replay.isOpen()) return title(setupTitle(insertion.control(), insertion.history()));
  return QCoreApplication::translate("perilymph::gui", "Replay of %1 — Perilymph")
      .arg(QString::fromStdString(session::displayNameOf(replay.playback().file())));
}

}  // namespace perilymph::gui
