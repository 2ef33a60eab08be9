// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientDetails.h"

#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <stop_token>
#include <utility>

#include "gui/pages/start/MeasureVersionList.h"
#include "gui/pages/start/PatientHistoryList.h"
#include "gui/text/DataText.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/NotesField.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int notesHeight_px = 96;

}  // namespace

PatientDetails::PatientDetails(QWidget* parent)
    : QWidget(parent),
      background_(this),
      name_(new ElidedLabel(this)),
      tags_(new QLineEdit(this)),
      notes_(new NotesField("patientNotes", tr("Notes on this ear; no names"), this,
                            session::maxNotes)),
      versions_(new MeasureVersionList(this)),
      empty_(new WrappedLabel(QString(), this)),
      history_(new PatientHistoryList(this))
{
  name_->setObjectName(QStringLiteral("patientDetailsName"));
  name_->setFont(typeface(15, QFont::Medium));
  tags_->setObjectName(QStringLiteral("patientTags"));
  tags_->setAccessibleName(tr("Tags"));
  tags_->setFont(typeface(13));
  tags_->setFixedHeight(sized(28));
  markPlaceholder(*tags_, tr("Tags, separated by commas; no names"));
  notes_->setFixedHeight(sized(notesHeight_px));
  empty_->setFont(typeface(13));
  empty_->setProperty("quiet", true);
  empty_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(name_);
  column->addWidget(tags_);
  column->addWidget(notes_);
  column->addWidget(panelHeading(tr("MEASURES"), this));
  column->addWidget(versions_);
  column->addWidget(panelHeading(tr("SCANS, PLANS, INSERTIONS, OUTCOMES"), this));
  column->addWidget(empty_, 1);  // in the place of the list
  column->addWidget(history_, 1);
  connect(tags_, &QLineEdit::editingFinished, this, &PatientDetails::keep);
  connect(notes_, &NotesField::left, this, &PatientDetails::keep);
  connect(notes_, &NotesField::cut, this, [this] {
    Q_EMIT said(tr("Notes have at most %1 characters; the end of what was typed or pasted is "
                   "not taken.")
                    .arg(session::maxNotes));
  });
  connect(history_, &PatientHistoryList::opened, this, &PatientDetails::opened);
  show(std::nullopt);
}

QString PatientDetails::handChanges(const SavedPatient& patient)
{
  if (patient.record.isChangedByHand) return tr(" · record changed by hand");
  const auto& versions = patient.record.versions;
  const bool areOthers =
      !versions.empty() && versions.back().patient != anatomy::patientText(patient.patient);
  return areOthers ? tr(" · measures changed by hand") : handChange(patient.patient);
}

void PatientDetails::show(const std::optional<SavedPatient>& patient)
{
  keep();
  const bool isSame = patient && patient_ && patient->file == patient_->file;
  isMerged_ = isMerged_ && isSame;
  patient_ = patient;
  tags_->setEnabled(patient.has_value());
  notes_->setEnabled(patient.has_value());
  name_->setText(patient ? nameOfPatient(patient->patient) + handChanges(*patient) : QString());
  session::PatientRecord record = patient ? patient->record : session::PatientRecord();
  if (const auto left = patient ? unsaved_.find(patient->file) : unsaved_.end();
      left != unsaved_.end())
    record = left->second;
  const QString notes = QString::fromStdString(record.notes);
  versions_->show(patient ? versionsOf(*patient) : std::vector<MeasureVersion>());
  tags_->setText(tagsText(record));
  // the same text is not set again: its changes can still be undone
  if (!isSame || notes_->toPlainText() != notes) notes_->setNotes(notes);
  showHistory();
}

session::PatientRecord PatientDetails::typed() const
{
  session::PatientRecord record = patient_->record;
  if (tags_->text() != tagsText(record)) {
    record.tags.clear();
    for (const QString& tag : tags_->text().split(QLatin1Char(','), Qt::SkipEmptyParts))
      if (!tag.trimmed().isEmpty()) record.tags.push_back(tag.trimmed().toStdString());
  }
  record.notes = notes_->toPlainText().toStdString();
  return record;
}

void PatientDetails::keep()
{
  if (!patient_) return;
  session::PatientRecord record = typed();
  unsaved_.erase(patient_->file);
  if (record == patient_->record) return;
  const auto saved = session::savePatientRecord(record, patient_->file);
  if (!saved) {
    takeOthersChange(record);
    unsaved_[patient_->file] = record;
    return said(dataText(saved.error().message));
  }
  const bool areTags = record.tags != patient_->record.tags;
  patient_->record = *saved;
  const SavedPatient kept = *patient_;
  Q_EMIT recordKept(kept);
  if (std::exchange(isMerged_, false))
    return said(tr("Another program changed the record of %1 meanwhile: its notes are kept before "
                   "yours.")
                    .arg(nameOfPatient(kept.patient)));
  Q_EMIT said((areTags ? tr("The tags of %1 are saved.") : tr("The notes on %1 are saved."))
                  .arg(nameOfPatient(kept.patient)));
}

void PatientDetails::takeOthersChange(session::PatientRecord& record)
{
  const auto now = session::loadPatientRecord(patient_->file);
  if (!now || now->base == patient_->record.base) return;
  // neither text is lost: both stand in the field, and what the user leaves there is saved
  if (now->notes != patient_->record.notes) {
    const bool isTyped = record.notes != patient_->record.notes && !record.notes.empty();
    record.notes = isTyped && !now->notes.empty() ? now->notes + "\n\n" + record.notes
                                                  : now->notes + (isTyped ? record.notes : "");
  }
  if (record.tags == patient_->record.tags) record.tags = now->tags;
  isMerged_ = true;
  patient_->record = *now;
  Q_EMIT recordKept(*patient_);
  const QSignalBlocker areSilent[] = {QSignalBlocker(tags_), QSignalBlocker(notes_)};
  tags_->setText(tagsText(record));
  notes_->setNotes(QString::fromStdString(record.notes));
}

std::array<QWidget*, 3> PatientDetails::fields() const { return {tags_, notes_, history_}; }

void PatientDetails::readHistory(const std::filesystem::path& beingRecorded)
{
  work_.reset();
  showHistory();
  background_.run(
      "The list of a patient's plans and insertions",
      [beingRecorded](const std::stop_token& stop) -> Result<PatientWork> {
        return readPatientWork(beingRecorded, stop);
      },
      [this](Result<PatientWork> work) {
        if (!work) return said(dataText(work.error().message));
        work_ = *std::move(work);
        showHistory();
      });
}

void PatientDetails::showHistory()
{
  const auto entries =
      patient_ && work_ ? historyOf(*patient_, *work_) : std::vector<HistoryEntry>();
  const bool isReading = patient_ && !work_;
  empty_->setText(isReading  ? tr("Reading…")
                  : patient_ ? tr("None yet. Scans are measured on the page CT, plans made on the "
                                  "page Plan; insertions of this patient are recorded, and "
                                  "outcomes saved on the page Outcome.")
                             : tr("Choose a patient."));
  empty_->setVisible(entries.empty());
  history_->setVisible(!entries.empty());
  history_->show(entries);
  if (patient_ && work_) noteWork(entries);
}

void PatientDetails::noteWork(const std::vector<HistoryEntry>& entries)
{
  std::vector<session::PatientEntry> plans, insertions;
  const auto add = [](const std::vector<session::PatientEntry>& known,
                      std::vector<session::PatientEntry>& added, const HistoryEntry& entry) {
    const std::string name = entry.place.filename().string();
    if (std::any_of(known.begin(), known.end(),
                    [&](const auto& each) { return each.name == name; }))
      return;
    added.push_back({entry.utc, name, entry.values.toStdString()});
  };
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {  // the oldest first
    if (entry->kind == HistoryEntry::Kind::plan) add(patient_->record.plans, plans, *entry);
    if (entry->kind == HistoryEntry::Kind::insertion)
      add(patient_->record.insertions, insertions, *entry);
  }
  if (plans.empty() && insertions.empty()) return;
  const auto before = patient_->record;
  const auto changed =
      session::changePatientRecord(patient_->file, [&](session::PatientRecord& record) {
        if (record.base != before.base) return;  // of another program: it is read again first
        record.plans.insert(record.plans.end(), plans.begin(), plans.end());
        record.insertions.insert(record.insertions.end(), insertions.begin(), insertions.end());
      });
  if (!changed || changed->notes != before.notes || changed->tags != before.tags) return;
  patient_->record = *changed;
  Q_EMIT recordKept(*patient_);
}

}  // namespace perilymph::gui
