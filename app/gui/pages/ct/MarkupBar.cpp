// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MarkupBar.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QVariant>
#include <utility>

#include "gui/pages/ct/CtText.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr std::array tools{ct::MarkupKind::distance, ct::MarkupKind::angle, ct::MarkupKind::note};
constexpr int longestEntry = 48;  // characters of a menu's line

/// A line of a menu; "&" is no mnemonic in a person's words.
QString entryText(const QString& text)
{
  QString line =
      text.size() > longestEntry ? text.left(longestEntry - 1) + QStringLiteral("…") : text;
  return line.replace(QLatin1Char('&'), QLatin1String("&&"));
}

}  // namespace

MarkupBar::MarkupBar(CtStudy& study, QWidget* parent)
    : QWidget(parent),
      study_(study),
      markups_(panelButton({}, "markupsButton", this)),
      keyImage_(panelButton(tr("Key image"), "keyImageButton", this)),
      keyImages_(panelButton({}, "keyImagesButton", this)),
      markupMenu_(new QMenu(markups_)),
      keyImageMenu_(new QMenu(keyImages_))
{
  setObjectName(QStringLiteral("markupBar"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(spacing, 4, spacing, 4);
  row->setSpacing(4);
  const std::array names{"distanceTool", "angleTool", "noteTool"};
  const std::array tips{
      tr("Click two points in any plane (D). Esc ends."),
      tr("Click a side, the vertex and the other side in any plane (A). Esc ends."),
      tr("Click a point and type the note (N). Esc ends.")};
  for (std::size_t k = 0; k < tools.size(); ++k) {
    QPushButton* button = tools_[k] = panelButton(markupName(tools[k]), names[k], this);
    button->setCheckable(true);
    button->setToolTip(tips[k]);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, tool = tools[k]](bool isOn) {
      study_.setTool(isOn ? std::optional(tool) : std::nullopt);
    });
  }
  row->addWidget(markups_);
  row->addStretch(1);
  row->addWidget(keyImage_);
  row->addWidget(keyImages_);
  for (QPushButton* button : {tools_[0], tools_[1], tools_[2], markups_, keyImage_, keyImages_})
    button->setProperty("small", true);
  keyImage_->setToolTip(
      tr("Keep the picture that was clicked last with its markups for the reports (K: the one "
         "under the mouse)"));
  markups_->setMenu(markupMenu_);
  keyImages_->setMenu(keyImageMenu_);
  connect(markupMenu_, &QMenu::aboutToShow, this, &MarkupBar::fillMarkups);
  connect(keyImageMenu_, &QMenu::aboutToShow, this, &MarkupBar::fillKeyImages);
  connect(keyImage_, &QPushButton::clicked, this, &MarkupBar::keyImageRequested);
  connect(&study_, &CtStudy::changed, this, &MarkupBar::refresh);
  refresh();
}

void MarkupBar::refresh()
{
  for (std::size_t k = 0; k < tools.size(); ++k) {
    tools_[k]->setChecked(study_.tool() == tools[k]);
    setPrimary(*tools_[k], study_.tool() == tools[k]);
    tools_[k]->setEnabled(study_.hasCt());
  }
  markups_->setEnabled(study_.hasCt());
  markups_->setText(tr("Markups (%1)").arg(study_.markups().size()));
  keyImage_->setEnabled(study_.hasCt());
  keyImages_->setText(tr("In the report (%1)").arg(images_.size()));
  keyImages_->setEnabled(!images_.empty());
}

void MarkupBar::showKeyImages(std::vector<CtKeyImage> images)
{
  images_ = std::move(images);
  refresh();
}

void MarkupBar::fillMarkups()
{
  markupMenu_->clear();
  const ct::CtMarkups whole = study_.ctMarkups();
  for (std::size_t k = 0; k < whole.markups.size(); ++k) {
    const ct::Markup& each = whole.markups[k];
    const QString text = markupText(each, whole.voxelEdges_P), name = markupName(each.kind);
    const QAction* go = markupMenu_->addAction(
        entryText(text == name ? name : QStringLiteral("%1  %2").arg(name, text)));
    connect(go, &QAction::triggered, this, [this, k, at_P = each.points_P.front()] {
      study_.chooseMarkup(k);
      study_.moveCrosshair(at_P);
    });
  }
  if (!whole.markups.empty()) markupMenu_->addSeparator();
  const auto add = [this](const QString& text, const char* name, bool isEnabled) {
    QAction* action = markupMenu_->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setEnabled(isEnabled);
    return action;
  };
  connect(add(tr("Remove the chosen one (Del)"), "removeMarkup", study_.chosenMarkup().has_value()),
          &QAction::triggered, this, [this] {
            if (const auto chosen = study_.chosenMarkup()) study_.removeMarkup(*chosen);
          });
  connect(add(tr("Undo (Ctrl+Z)"), "undoMarkup", study_.canUndo()), &QAction::triggered, &study_,
          &CtStudy::undo);
  markupMenu_->addSeparator();
  const bool hasAny = !whole.markups.empty();
  connect(add(tr("Export for 3D Slicer (LPS)…"), "exportSlicerMarkups", hasAny),
          &QAction::triggered, this, &MarkupBar::slicerRequested);
  connect(add(tr("Export as a table (CSV, LPS)…"), "exportMarkupTable", hasAny),
          &QAction::triggered, this, &MarkupBar::tableRequested);
  connect(add(tr("Load from 3D Slicer…"), "loadMarkups", study_.hasCt()), &QAction::triggered, this,
          &MarkupBar::loadRequested);
  if (keeping_.isEmpty()) return;
  markupMenu_->addSeparator();
  add(keeping_, "markupKeeping", false);
}

void MarkupBar::fillKeyImages()
{
  keyImageMenu_->clear();
  for (const CtKeyImage& each : images_) {
    QMenu* own =
        keyImageMenu_->addMenu(entryText(each.caption.isEmpty() ? each.place : each.caption));
    own->addAction(entryText(each.place))->setEnabled(false);
    connect(own->addAction(tr("Remove from the report")), &QAction::triggered, this,
            [this, file = each.file] { Q_EMIT keyImageRemoved(file); });
  }
}

}  // namespace perilymph::gui
