// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/ScenarioHeader.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/setup/SetupHistory.h"
#include "gui/text/DataText.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/Reference.h"

namespace perilymph::gui {

namespace {

constexpr int undoWidth_px = 106;
constexpr int redoWidth_px = undoWidth_px;
constexpr auto publishedPreset = "contour-published";

QString elided(const QString& text, const QFont& font, int width_px)
{
  return QFontMetrics(font).elidedText(text, Qt::ElideRight, width_px);
}

/// Source of a preset's values.
QString citationOf(const session::Scenario& preset)
{
  if (preset.name() != publishedPreset) return {};
  const auto reference = analysis::shippedReference("todd-naghdy-experiment");
  return reference ? QString::fromStdString(reference->source) : QString();
}

}  // namespace

ScenarioHeader::ScenarioHeader(QWidget* parent)
    : QWidget(parent),
      badge_(new QLabel(tr("MODIFIED"), this)),
      title_(new QLabel(this)),
      locked_(new QLabel(tr("Locked during an insertion"), this)),
      restore_(addButton(tr("Restore the published values"), "restoreButton")),
      undo_(addButton(tr("Undo"), "undoButton")),
      redo_(addButton(tr("Redo"), "redoButton"))
{
  auto* heading = new QLabel(tr("SCENARIO"), this);
  heading->setFont(typeface(11, QFont::DemiBold));
  heading->setProperty("quiet", true);
  badge_->setObjectName(QStringLiteral("modifiedBadge"));
  badge_->setProperty("badge", true);
  badge_->setFixedHeight(sized(20));
  badge_->setFont(typeface(11, QFont::DemiBold));
  auto* collapse = addButton(QStringLiteral("◂"), "collapseButton");
  collapse->setFixedSize(sized(22), sized(20));
  collapse->setToolTip(tr("Hide the panel (B)"));
  collapse->setAccessibleName(tr("Hide the panel"));
  collapse->setFocusPolicy(Qt::NoFocus);

  title_->setObjectName(QStringLiteral("scenarioTitle"));
  title_->setFont(typeface(13, QFont::Medium));
  title_->setWordWrap(true);
  locked_->setObjectName(QStringLiteral("lockedLabel"));
  locked_->setFont(typeface(11));
  locked_->setProperty("quiet", true);
  locked_->setFixedHeight(sized(22));
  locked_->setToolTip(tr("The setup can be changed before and after an insertion. Press Reset."));
  locked_->hide();
  undo_->setFixedWidth(sized(undoWidth_px));
  redo_->setFixedWidth(sized(redoWidth_px));

  auto* top = new QHBoxLayout;
  top->setSpacing(spacing);
  top->addWidget(heading);
  top->addStretch();
  top->addWidget(badge_);
  top->addWidget(collapse);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  buttons->addWidget(undo_);
  buttons->addWidget(redo_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addLayout(top);
  column->addWidget(title_);
  column->addWidget(restore_);
  column->addLayout(buttons);
  column->addWidget(locked_);

  connect(collapse, &QPushButton::clicked, this, &ScenarioHeader::collapseRequested);
  connect(restore_, &QPushButton::clicked, this, &ScenarioHeader::restoreRequested);
  connect(undo_, &QPushButton::clicked, this, &ScenarioHeader::undoRequested);
  connect(redo_, &QPushButton::clicked, this, &ScenarioHeader::redoRequested);
}

QPushButton* ScenarioHeader::addButton(const QString& text, const char* name)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(QLatin1String(name));
  button->setProperty("small", true);
  button->setFont(typeface(11));
  button->setFixedHeight(sized(22));
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void ScenarioHeader::show(const SetupHistory& history)
{
  const SetupOrigin& origin = history.origin();
  const bool isPreset = origin.kind == SetupOrigin::Kind::preset;
  const session::Scenario& claimed = isPreset ? origin.setup.scenario : history.now().scenario;
  const QString title = dataText(claimed.title());
  const QString citation = isPreset ? citationOf(claimed) : QString();
  const bool isModified = history.isModified();
  // a modified preset is called by the array in use, because its title may name another one
  title_->setText(isModified ? tr("%1 · modified from %2")
                                   .arg(QString::fromStdString(history.now().scenario.array().name),
                                        QString::fromStdString(claimed.name()))
                  : title.isEmpty() ? QString::fromStdString(claimed.name())
                                    : title);
  title_->setToolTip(
      isModified ? tr("%1. Changed: %2. %3").arg(title, history.changedText(), citation).trimmed()
                 : citation);

  badge_->setVisible(isModified);
  badge_->setToolTip(tr("Differs from the preset: %1.").arg(history.changedText()));
  restore_->setVisible(isModified);
  const bool isPublished = claimed.name() == publishedPreset;
  restore_->setText(isPublished ? tr("Restore the published values") : tr("Restore the preset"));
  restore_->setToolTip(tr("Changed: %1. %2").arg(history.changedText(), citation).trimmed());

  const QUndoStack& stack = history.stack();
  canUndo_ = stack.canUndo();
  canRedo_ = stack.canRedo();
  const QString undo = canUndo_ ? tr("Undo %1").arg(stack.undoText()) : tr("Undo");
  const QString redo = canRedo_ ? tr("Redo %1").arg(stack.redoText()) : tr("Redo");
  undo_->setText(elided(undo, undo_->font(), sized(undoWidth_px) - 18));
  undo_->setToolTip(tr("%1 (Ctrl+Z)").arg(undo));
  undo_->setAccessibleName(undo);
  redo_->setText(elided(redo, redo_->font(), sized(redoWidth_px) - 18));
  redo_->setToolTip(tr("%1 (Ctrl+Shift+Z)").arg(redo));
  redo_->setAccessibleName(redo);
  enableButtons();
}

void ScenarioHeader::setChangeable(bool isChangeable)
{
  isChangeable_ = isChangeable;
  locked_->setVisible(!isChangeable);
  undo_->setVisible(isChangeable);
  redo_->setVisible(isChangeable);
  enableButtons();
}

void ScenarioHeader::enableButtons()
{
  undo_->setEnabled(isChangeable_ && canUndo_);
  redo_->setEnabled(isChangeable_ && canRedo_);
  restore_->setEnabled(isChangeable_);
}

}  // namespace perilymph::gui
