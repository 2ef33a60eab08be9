// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientPicker.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/parts/CheckBoxes.h"
#include "gui/parts/Placeholder.h"
#include "gui/parts/Theme.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 560;

QString tagsOf(const session::PatientRecord& record)
{
  QStringList tags;
  for (const std::string& tag : record.tags) tags << QString::fromStdString(tag);
  return tags.join(QStringLiteral(", "));
}

/// Recordings in the session folder of a patient's ear.
std::vector<std::filesystem::path> insertionsOf(const anatomy::Patient& patient)
{
  std::vector<std::filesystem::path> files;
  const auto sessions = session::listSessions(sessionFolder());
  if (!sessions) return files;  // none was recorded yet
  const std::string side = patient.side == anatomy::Side::left ? "left" : "right";
  for (const session::SessionSummary& each : *sessions)
    if (each.patient == patient.label && each.side == side) files.push_back(each.file);
  return files;
}

}  // namespace

PatientPicker::PatientPicker(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      status_(new QLabel(this)),
      tags_(new QLineEdit(this)),
      archived_(new CheckBox(tr("Show archived"), this)),
      open_(new QPushButton(tr("Open"), this)),
      edit_(new QPushButton(tr("Edit…"), this)),
      archive_(new QPushButton(this)),
      export_(new QPushButton(tr("Export…"), this))
{
  setFixedWidth(sized(width_px));
  auto* title = new QLabel(tr("Saved patients"), this);
  title->setFont(typeface(22));
  search_->setObjectName(QStringLiteral("patientSearch"));
  search_->setAccessibleName(tr("Find patients"));
  search_->setFont(typeface(13));
  search_->setFixedHeight(sized(32));
  search_->setClearButtonEnabled(true);
  markPlaceholder(*search_, tr("Find by code, ear or tag"));
  search_->installEventFilter(this);
  list_->setObjectName(QStringLiteral("patientList"));
  list_->setAccessibleName(tr("Saved patients"));
  list_->setFont(typeface(13));
  status_->setFont(typeface(13));
  status_->setProperty("quiet", true);
  status_->setWordWrap(true);
  tags_->setObjectName(QStringLiteral("patientTags"));
  tags_->setAccessibleName(tr("Tags"));
  tags_->setFont(typeface(13));
  tags_->setFixedHeight(sized(28));
  markPlaceholder(*tags_, tr("Tags, separated by commas; no names"));
  archived_->setObjectName(QStringLiteral("showArchived"));
  archived_->setFont(typeface(13));
  auto* import = new QPushButton(tr("Import…"), this);
  import->setObjectName(QStringLiteral("importPatientButton"));
  archive_->setObjectName(QStringLiteral("archivePatientButton"));
  export_->setObjectName(QStringLiteral("exportPatientButton"));
  auto* library = new QHBoxLayout;
  library->setSpacing(spacing);
  library->addWidget(archived_);
  library->addStretch();
  library->addWidget(import);
  library->addWidget(export_);
  library->addWidget(archive_);
  auto* back = new QPushButton(tr("Back"), this);
  back->setObjectName(QStringLiteral("leavePickerButton"));
  open_->setObjectName(QStringLiteral("openPatientButton"));
  open_->setProperty("primary", true);
  edit_->setObjectName(QStringLiteral("editPatientButton"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(spacing);
  buttons->addWidget(back);
  buttons->addStretch();
  buttons->addWidget(edit_);
  buttons->addWidget(open_);
  for (QPushButton* button : {back, edit_, open_, import, export_, archive_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(sized(32));
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 3 * spacing, 0, 3 * spacing);
  column->setSpacing(spacing);
  column->addWidget(title);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addWidget(tags_);
  column->addLayout(library);
  column->addWidget(status_);
  column->addLayout(buttons);

  connect(search_, &QLineEdit::textChanged, this, &PatientPicker::showMatches);
  connect(search_, &QLineEdit::returnPressed, this, &PatientPicker::openSelected);
  connect(list_, &QListWidget::itemActivated, this, &PatientPicker::openSelected);
  connect(open_, &QPushButton::clicked, this, &PatientPicker::openSelected);
  connect(edit_, &QPushButton::clicked, this, [this] {
    if (const SavedPatient* patient = selected()) Q_EMIT editAsked(SavedPatient(*patient));
  });
  connect(back, &QPushButton::clicked, this, &PatientPicker::leaveAsked);
  connect(list_, &QListWidget::currentRowChanged, this, &PatientPicker::showRecord);
  connect(tags_, &QLineEdit::editingFinished, this, &PatientPicker::keepTags);
  connect(archived_, &QAbstractButton::toggled, this, &PatientPicker::showMatches);
  connect(archive_, &QPushButton::clicked, this, &PatientPicker::changeArchived);
  connect(export_, &QPushButton::clicked, this, &PatientPicker::exportSelected);
  connect(import, &QPushButton::clicked, this, &PatientPicker::importPatient);
  setTabOrder(search_, list_);
  setTabOrder(list_, tags_);
  setTabOrder(tags_, archived_);
  setTabOrder(archived_, import);
  setTabOrder(import, export_);
  setTabOrder(export_, archive_);
  setTabOrder(archive_, open_);
  setTabOrder(open_, edit_);
  setTabOrder(edit_, back);
  setFocusProxy(search_);
}

void PatientPicker::refresh()
{
  patients_ = savedPatients();
  search_->clear();
  showMatches();
}

void PatientPicker::showMatches()
{
  const QString wanted = search_->text().trimmed();
  list_->clear();
  shown_.clear();
  for (std::size_t i = 0; i < patients_.size(); ++i) {
    const QString name = nameOfPatient(patients_[i].patient);
    const session::PatientRecord& record = patients_[i].record;
    if (record.isArchived && !archived_->isChecked()) continue;
    const QString tags = tagsOf(record);
    const QString whole = tags.isEmpty() ? name : tr("%1 · %2").arg(name, tags);
    if (!whole.contains(wanted, Qt::CaseInsensitive)) continue;
    list_->addItem(tr("%1 · %2").arg(whole, numbersOfPatient(patients_[i].patient)));
    shown_.push_back(i);
  }
  if (!shown_.empty()) list_->setCurrentRow(0);
  open_->setEnabled(!shown_.empty());
  edit_->setEnabled(!shown_.empty());
  showRecord();
  status_->setText(patients_.empty() ? tr("No patient is saved yet.")
                   : shown_.empty()  ? tr("No patient matches “%1”.").arg(wanted)
                                     : tr("%1 of %2").arg(shown_.size()).arg(patients_.size()));
}

const SavedPatient* PatientPicker::selected() const
{
  const int row = list_->currentRow();
  if (row < 0 || row >= int(shown_.size())) return nullptr;
  return &patients_[shown_[std::size_t(row)]];
}

void PatientPicker::openSelected()
{
  if (const SavedPatient* patient = selected()) Q_EMIT openAsked(SavedPatient(*patient));
}

void PatientPicker::showRecord()
{
  const SavedPatient* patient = selected();
  for (QWidget* each : {static_cast<QWidget*>(tags_), static_cast<QWidget*>(archive_),
                        static_cast<QWidget*>(export_)})
    each->setEnabled(patient != nullptr);
  tags_->setText(patient ? tagsOf(patient->record) : QString());
  archive_->setText(patient && patient->record.isArchived ? tr("Restore") : tr("Archive"));
}

void PatientPicker::show(const Result<Done>& done, const QString& sentence)
{
  status_->setText(done ? sentence : QString::fromStdString(done.error().message));
}

void PatientPicker::keepTags()
{
  const SavedPatient* patient = selected();
  if (patient == nullptr || tags_->text() == tagsOf(patient->record)) return;
  session::PatientRecord record = patient->record;
  record.tags.clear();
  for (const QString& tag : tags_->text().split(QLatin1Char(','), Qt::SkipEmptyParts))
    if (!tag.trimmed().isEmpty()) record.tags.push_back(tag.trimmed().toStdString());
  const QString name = nameOfPatient(patient->patient);
  const auto saved = session::savePatientRecord(record, patient->file);
  if (saved) {
    patients_[shown_[std::size_t(list_->currentRow())]].record = record;
    const int row = list_->currentRow();
    showMatches();
    list_->setCurrentRow(std::min(row, list_->count() - 1));
  }
  show(saved, tr("The tags of %1 are saved.").arg(name));
}

void PatientPicker::changeArchived()
{
  const SavedPatient* patient = selected();
  if (patient == nullptr) return;
  session::PatientRecord record = patient->record;
  record.isArchived = !record.isArchived;
  const QString name = nameOfPatient(patient->patient);
  const auto saved = session::savePatientRecord(record, patient->file);
  if (saved) {
    patients_[shown_[std::size_t(list_->currentRow())]].record = record;
    showMatches();
  }
  show(saved, record.isArchived ? tr("%1 is archived; nothing is deleted.").arg(name)
                                : tr("%1 is in the list again.").arg(name));
}

void PatientPicker::exportSelected()
{
  const SavedPatient* patient = selected();
  if (patient == nullptr) return;
  const QString place = QFileDialog::getExistingDirectory(this, tr("Folder for the export"));
  if (place.isEmpty()) return;
  const std::filesystem::path folder =
      std::filesystem::path(place.toStdString()) / patient->file.stem();
  show(session::exportPatient(patient->file, insertionsOf(patient->patient), folder),
       tr("%1 is exported to %2.")
           .arg(nameOfPatient(patient->patient), QString::fromStdString(folder.string())));
}

void PatientPicker::importPatient()
{
  const QString place =
      QFileDialog::getExistingDirectory(this, tr("Folder of an exported patient"));
  if (place.isEmpty()) return;
  const auto file = session::importPatient(place.toStdString(), patientFolder(), sessionFolder());
  if (file) refresh();
  show(file ? Result<Done>(Done{}) : Result<Done>(file.error()), tr("The patient is imported."));
}

bool PatientPicker::eventFilter(QObject* watched, QEvent* event)
{
  // Up and Down move in the list while the search is typed.
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      QCoreApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace perilymph::gui
