// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/OutcomePanel.h"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/pages/ct/CtSource.h"
#include "gui/pages/outcome/SurgeryForm.h"
#include "gui/setup/PatientHistory.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int outcomePanel_px = 300;

QString keyOf(const SavedPatient& patient) { return QString::fromStdString(patient.file.string()); }

/// "2026-11-28 09:30 · flex28 · 421 (409–433)°"
QString versionText(const session::PatientOutcome& saved)
{
  return OutcomePanel::tr("%1 · %2").arg(localTimeText(saved.utc), outcomeWords(saved));
}

}  // namespace

OutcomePanel::OutcomePanel(QWidget* parent)
    : QWidget(parent),
      patientList_(new Selector("outcomePatientSelector", tr("Patient"), this)),
      versions_(new Selector("outcomeVersions", tr("Saved outcomes"), this)),
      form_(new SurgeryForm(this)),
      source_(new CtSource(this, QStringLiteral("outcome-"))),
      status_(new WrappedLabel({}, this)),
      progress_(new QProgressBar(this)),
      find_(rowButton(tr("Find the contacts"), "findContactsButton", this)),
      cancel_(rowButton(tr("Cancel"), "cancelContactsButton", this)),
      undo_(rowButton(tr("Undo"), "undoContactButton", this)),
      redo_(rowButton(tr("Redo"), "redoContactButton", this)),
      save_(rowButton(tr("Save in the record"), "saveOutcomeButton", this)),
      export_(rowButton(tr("Export…"), "exportOutcomeButton", this)),
      report_(rowButton(tr("Report…"), "outcomeReportButton", this))
{
  setObjectName(QStringLiteral("outcomePanel"));
  setFixedWidth(sized(outcomePanel_px));
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  column->setSpacing(spacing);
  column->addWidget(panelHeading(tr("PATIENT"), this));
  column->addWidget(patientList_);
  column->addWidget(versions_);
  column->addWidget(panelHeading(tr("1  WHAT THE SURGEON KNOWS"), this));
  column->addWidget(form_);
  column->addWidget(panelHeading(tr("2  CT AFTER SURGERY"), this));
  column->addWidget(source_);
  column->addStretch();
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(2 * spacing, spacing, 2 * spacing, 2 * spacing);
  foot->setSpacing(spacing);
  addFoot(*foot);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(verticalScroll(content, this), 1);
  whole->addLayout(foot);
  connect(patientList_, &Selector::chosen, this, [this](const QString& key) {
    showPatient();
    if (!patient_ || keyOf(*patient_) != key) Q_EMIT patientWanted(key.toStdString());
  });
  connect(versions_, &Selector::chosen, this, [this](const QString& place) {
    versions_->show(version_, {});
    if (!place.isEmpty()) Q_EMIT versionWanted(place.toULong());
  });
  connect(form_, &SurgeryForm::changed, this, &OutcomePanel::showButtons);
  refresh();
  showIdle({});
}

void OutcomePanel::addFoot(QVBoxLayout& column)
{
  status_->setObjectName(QStringLiteral("outcomeStatus"));
  status_->setFont(typeface(12));
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setRange(0, 1000);
  cancel_->setToolTip(tr("Esc"));
  undo_->setToolTip(tr("The contact that was moved last (Ctrl+Z)"));
  redo_->setToolTip(tr("Ctrl+Shift+Z"));
  report_->setToolTip(tr("One page as PDF or DICOM"));
  column.addWidget(status_);
  column.addWidget(progress_);
  column.addWidget(cancel_);
  column.addWidget(find_);
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  grid->addWidget(undo_, 0, 0);
  grid->addWidget(redo_, 0, 1);
  grid->addWidget(export_, 1, 0);
  grid->addWidget(report_, 1, 1);
  column.addLayout(grid);
  column.addWidget(save_);
  for (QPushButton* each : {undo_, redo_, export_, report_}) each->setProperty("small", true);
  auto* kinds = new QMenu(export_);
  const auto add = [&](const QString& text, const char* name, OutcomeExport kind) {
    QAction* action = kinds->addAction(text);
    action->setObjectName(QLatin1String(name));
    connect(action, &QAction::triggered, this, [this, kind] { Q_EMIT exportRequested(kind); });
  };
  add(tr("Table of the contacts (CSV)…"), "exportOutcomeTable", OutcomeExport::table);
  add(tr("Everything (JSON)…"), "exportOutcomeJson", OutcomeExport::json);
  add(tr("Markups for 3D Slicer…"), "exportOutcomeMarkups", OutcomeExport::markups);
  add(tr("Picture of the cochlear view…"), "exportOutcomePicture", OutcomeExport::picture);
  export_->setMenu(kinds);
  connect(find_, &QPushButton::clicked, this, &OutcomePanel::findRequested);
  connect(cancel_, &QPushButton::clicked, this, &OutcomePanel::cancelRequested);
  connect(undo_, &QPushButton::clicked, this, &OutcomePanel::undoRequested);
  connect(redo_, &QPushButton::clicked, this, &OutcomePanel::redoRequested);
  connect(save_, &QPushButton::clicked, this, &OutcomePanel::saveRequested);
  connect(report_, &QPushButton::clicked, this, &OutcomePanel::reportRequested);
}

void OutcomePanel::refresh()
{
  patients_ = savedPatients();
  std::erase_if(patients_, [](const SavedPatient& each) { return !each.patient.basalTurn; });
  const QString before = patient_ ? keyOf(*patient_) : QString();
  patientList_->clear();
  for (const SavedPatient& each : patients_)
    patientList_->addChoice(nameOfPatient(each.patient), keyOf(each),
                            numbersOfPatient(each.patient));
  patient_.reset();
  for (const SavedPatient& each : patients_)
    if (keyOf(each) == before) patient_ = each;
  showPatient();
  listVersions();
  showButtons();
}

void OutcomePanel::showPatient()
{
  if (patient_)
    patientList_->show(keyOf(*patient_), {});
  else
    patientList_->show({}, patients_.empty() ? tr("Save a patient first") : tr("Choose a patient"));
}

void OutcomePanel::showVersion(std::size_t place)
{
  version_ = QString::number(place);
  versions_->show(version_, {});
  showButtons();
}

bool OutcomePanel::choosePatient(const std::filesystem::path& file)
{
  const QString key = QString::fromStdString(file.string());
  if (!patient_ || keyOf(*patient_) != key) {
    patientList_->show(key, {});
    choose(key);
  }
  return patient_ && keyOf(*patient_) == key;
}

void OutcomePanel::choose(const QString& key)
{
  const auto found =
      std::ranges::find_if(patients_, [&](const SavedPatient& each) { return keyOf(each) == key; });
  if (found == patients_.end()) return;
  patient_ = *found;
  listVersions();
  showButtons();
  Q_EMIT patientChosen();
}

void OutcomePanel::listVersions()
{
  versions_->clear();
  const std::size_t count = patient_ ? patient_->record.outcomes.size() : 0;
  versions_->addChoice(count == 0   ? tr("no outcome saved yet")
                       : count == 1 ? tr("1 saved outcome")
                                    : tr("%1 saved outcomes").arg(count),
                       QString());
  for (std::size_t place = count; place-- > 0;)
    versions_->addChoice(versionText(patient_->record.outcomes[place]), QString::number(place));
  version_.clear();
  versions_->show({}, {});
}

void OutcomePanel::showTask(const QString& task, double fraction)
{
  isBusy_ = true;
  showSentence(*status_, task, false);
  progress_->setValue(int(1000.0 * fraction));
  showButtons();
}

void OutcomePanel::showIdle(const QString& sentence, bool isError)
{
  isBusy_ = false;
  showSentence(*status_, sentence, isError);
  showButtons();
}

void OutcomePanel::showState(const State& state)
{
  state_ = state;
  showButtons();
}

void OutcomePanel::showButtons()
{
  const bool isValid = form_->error().isEmpty();
  const bool isReady = patient_ && state_.hasCt && isValid && !form_->surgery().array.empty();
  status_->setVisible(!status_->text().isEmpty());
  progress_->setVisible(isBusy_);
  cancel_->setVisible(isBusy_);
  find_->setVisible(!isBusy_);
  find_->setEnabled(isReady);
  find_->setToolTip(!patient_       ? tr("Choose a patient with A and B first.")
                    : !state_.hasCt ? tr("Open the CT after surgery first.")
                    : !isValid      ? tr("Correct the form first.")
                    : isReady       ? QString()
                                    : tr("Choose the implanted array first."));
  undo_->setEnabled(state_.canUndo);
  redo_->setEnabled(state_.canRedo);
  const bool isFound = state_.hasFound && !isBusy_;
  // an earlier version counts again when it is saved as the newest
  const bool isNewest =
      version_.isEmpty() || !patient_ || version_.toULong() + 1 == patient_->record.outcomes.size();
  const bool canSave =
      isFound && patient_ && isValid && state_.obstacle.isEmpty() && !(state_.isSaved && isNewest);
  save_->setEnabled(canSave);
  save_->setToolTip(
      !state_.obstacle.isEmpty() ? state_.obstacle
      : isNewest
          ? tr("Every outcome that is saved stays in the patient’s record, with its date.")
          : tr("Saves this earlier version as the newest, which counts among the outcomes."));
  export_->setEnabled(state_.hasFound);
  report_->setEnabled(state_.hasFound && patient_);
  setPrimary(*find_, !state_.hasFound);
  setPrimary(*save_, canSave && !state_.isSaved);
  versions_->setEnabled(patient_ && !patient_->record.outcomes.empty() && !isBusy_);
  patientList_->setEnabled(!isBusy_ && !patients_.empty());
}

}  // namespace perilymph::gui
