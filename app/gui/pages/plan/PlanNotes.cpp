// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanNotes.h"

#include "gui/setup/PlanStore.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int height_px = 52;

}  // namespace

PlanNotes::PlanNotes(QWidget* parent) : NotesField("planNotes", tr("Notes on this plan"), parent)
{
  setFixedHeight(sized(height_px));
  connect(this, &NotesField::edited, this, &PlanNotes::keep);
}

void PlanNotes::show(const std::filesystem::path& folder)
{
  if (folder == folder_) return;
  folder_ = folder;
  setNotes(folder.empty() ? QString() : notesOf(folder));
}

void PlanNotes::keep()
{
  if (folder_.empty()) return;
  const auto saved = saveNotes(folder_, toPlainText());
  if (!saved) Q_EMIT failed(dataText(saved.error().message));
}

}  // namespace perilymph::gui
