// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanNotes.h"

#include <QSignalBlocker>
#include <QStyle>
#include <QVariant>

#include "gui/pages/plan/PlanStore.h"
#include "gui/parts/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int height_px = 52;

}  // namespace

PlanNotes::PlanNotes(QWidget* parent) : QPlainTextEdit(parent)
{
  setObjectName(QStringLiteral("planNotes"));
  setAccessibleName(tr("Notes on this plan"));
  setPlaceholderText(tr("Notes on this plan"));
  setFont(typeface(13));
  setFixedHeight(sized(height_px));
  setTabChangesFocus(true);
  showHint();
  connect(this, &QPlainTextEdit::textChanged, this, &PlanNotes::keep);
}

void PlanNotes::show(const std::filesystem::path& folder)
{
  if (folder == folder_) return;
  folder_ = folder;
  const QSignalBlocker quiet(this);
  setPlainText(folder.empty() ? QString() : notesOf(folder));
  showHint();
}

/// The hint of an empty field is quiet.
void PlanNotes::showHint()
{
  setProperty("hint", document()->isEmpty());
  style()->unpolish(this);
  style()->polish(this);
}

void PlanNotes::keep()
{
  if (property("hint").toBool() != document()->isEmpty()) showHint();
  if (folder_.empty()) return;
  const auto saved = saveNotes(folder_, toPlainText());
  if (!saved) Q_EMIT failed(QString::fromStdString(saved.error().message));
}

}  // namespace perilymph::gui
