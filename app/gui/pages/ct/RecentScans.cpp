// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/RecentScans.h"

#include "gui/setup/PatientHistory.h"
#include "gui/setup/ScanFolders.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

RecentScans::RecentScans(QWidget* parent) : QMenu(parent)
{
  setObjectName(QStringLiteral("recentScans"));
  setFont(typeface(13));
  connect(this, &QMenu::aboutToShow, this, &RecentScans::read);
}

void RecentScans::read()
{
  clear();
  for (const ReadScan& each : recentScans()) {
    const QString code =
        each.code.empty() ? tr("without a code") : QString::fromStdString(each.code);
    const CtRequest request{QString::fromStdString(each.code), each.series};
    connect(addAction(tr("%1 · opened %2").arg(code, localTimeText(each.utc))), &QAction::triggered,
            this, [this, request] { Q_EMIT chosen(request); });
  }
  if (!isEmpty()) return;
  addAction(tr("No CT was opened yet, or the list was cleared."))->setEnabled(false);
}

}  // namespace perilymph::gui
