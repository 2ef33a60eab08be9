// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientPicker.h"

#include <QCoreApplication>
#include <QDate>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <memory>
#include <stop_token>

#include "gui/pages/start/PatientDetails.h"
#include "gui/setup/TableFiles.h"
#include "gui/text/DataText.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/PatientRegistry.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

namespace {

constexpr int maxWidth_px = 1080;

/// Recordings in the folder of recordings of a patient's ear.
std::vector<std::filesystem::path> insertionsOf(const anatomy::Patient& patient)
{
  std::vector<std::filesystem::path> files;
  const auto sessions = session::listSessions(sessionFolder());
  if (!sessions) return files;  // none was recorded yet
  const std::string side = anatomy::nameOf(patient.side);
  for (const session::SessionSummary& each : *sessions)
    if (each.patient == patient.label && each.side == side) files.push_back(each.file);
  return files;
}

void showLine(QListWidgetItem& item, const SavedPatient& patient)
{
  const QString name = nameOfPatient(patient.patient), tags = tagsText(patient.record);
  const QString whole = tags.isEmpty() ? name : PatientPicker::tr("%1 · %2").arg(name, tags);
  item.setText(PatientPicker::tr("%1 · %2").arg(whole, numbersOfPatient(patient.patient)));
  item.setToolTip(item.text().toHtmlEscaped());
}

}  // namespace

PatientPicker::PatientPicker(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      details_(new PatientDetails(this)),
      status_(new WrappedLabel(QString(), this)),
      archived_(new CheckBox(tr("Show archived"), this)),
      import_(addButton(tr("Import…"), "importPatientButton")),
      table_(addButton(tr("Table…"), "exportTableButton")),
      open_(addButton(tr("Open"), "openPatientButton")),
      edit_(addButton(tr("Edit…"), "editPatientButton")),
      archive_(addButton(QString(), "archivePatientButton")),
      export_(addButton(tr("Export…"), "exportPatientButton")),
      back_(addButton(tr("Back"), "leavePickerButton")),
      cancel_(addButton(tr("Cancel"), "cancelTransferButton")),
      transfer_(new PatientTransfer(this))
{
  setMaximumWidth(sized(maxWidth_px));
  auto* title = new QLabel(tr("Saved patients"), this);
  title->setFont(typeface(22));
  status_->setObjectName(QStringLiteral("patientStatus"));
  status_->setTextFormat(Qt::PlainText);
  status_->setFont(typeface(13));
  status_->setProperty("quiet", true);
  open_->setProperty("primary", true);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(3 * spacing);
  columns->addLayout(addList(), 1);
  columns->addLayout(addSelected(), 1);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(2 * spacing, 3 * spacing, 2 * spacing, 3 * spacing);
  whole->setSpacing(spacing);
  whole->addWidget(title);
  whole->addLayout(columns, 1);
  auto* footer = new QHBoxLayout;
  footer->setSpacing(spacing);
  footer->addWidget(status_, 1);
  footer->addWidget(cancel_);
  whole->addLayout(footer);
  cancel_->hide();

  connect(search_, &QLineEdit::textChanged, this, &PatientPicker::showMatches);
  connect(search_, &QLineEdit::returnPressed, this, &PatientPicker::openSelected);
  connect(list_, &QListWidget::itemActivated, this, &PatientPicker::openSelected);
  connect(open_, &QPushButton::clicked, this, &PatientPicker::openSelected);
  connect(edit_, &QPushButton::clicked, this, [this] {
    if (const SavedPatient* patient = selected()) Q_EMIT editRequested(SavedPatient(*patient));
  });
  connect(back_, &QPushButton::clicked, this, &PatientPicker::leaveRequested);
  connect(list_, &QListWidget::currentRowChanged, this, &PatientPicker::showSelected);
  connect(details_, &PatientDetails::recordKept, this, &PatientPicker::takeRecord);
  connect(details_, &PatientDetails::said, status_, &QLabel::setText);
  connect(details_, &PatientDetails::opened, this, &PatientPicker::entryRequested);
  connect(archived_, &QAbstractButton::toggled, this, &PatientPicker::showMatches);
  connect(archive_, &QPushButton::clicked, this, &PatientPicker::changeArchived);
  connect(export_, &QPushButton::clicked, this, &PatientPicker::exportSelected);
  connect(import_, &QPushButton::clicked, this, &PatientPicker::importPatient);
  table_->setToolTip(tr(
      "Save all patients as CSV, a row per ear: measures, newest plan and newest insertion, with a "
      "dictionary of the columns. It names nobody."));
  connect(table_, &QPushButton::clicked, this, &PatientPicker::exportTable);
  connect(cancel_, &QPushButton::clicked, transfer_, &PatientTransfer::cancel);
  connect(transfer_, &PatientTransfer::progressed, this,
          [this](int percent) { status_->setText(task_.arg(percent)); });
  connect(transfer_, &PatientTransfer::copied, this,
          [this](const QString& place) { showTransfer(transferDone_(place)); });
  connect(transfer_, &PatientTransfer::failed, this, &PatientPicker::showTransfer);
  setTabOrders();
  setFocusProxy(search_);
}

QPushButton* PatientPicker::addButton(const QString& text, const char* name)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedHeight(sized(32));
  return button;
}

/// The patients, and what changes the list.
QLayout* PatientPicker::addList()
{
  search_->setObjectName(QStringLiteral("patientSearch"));
  search_->setAccessibleName(tr("Find patients"));
  search_->setFont(typeface(13));
  search_->setFixedHeight(sized(32));
  search_->setClearButtonEnabled(true);
  markPlaceholder(*search_, tr("Find by code, ear, tag or note"));
  search_->installEventFilter(this);
  list_->setObjectName(QStringLiteral("patientList"));
  list_->setAccessibleName(tr("Saved patients"));
  list_->setFont(typeface(13));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  archived_->setObjectName(QStringLiteral("showArchived"));
  archived_->setFont(typeface(13));
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  verbs->addWidget(back_);
  verbs->addWidget(archived_);
  verbs->addStretch();
  verbs->addWidget(table_);
  verbs->addWidget(import_);
  auto* column = new QVBoxLayout;
  column->setSpacing(spacing);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addLayout(verbs);
  return column;
}

/// The selected patient, and what can be done with it.
QLayout* PatientPicker::addSelected()
{
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  verbs->addWidget(archive_);
  verbs->addWidget(export_);
  verbs->addStretch();
  verbs->addWidget(edit_);
  verbs->addWidget(open_);
  auto* column = new QVBoxLayout;
  column->setSpacing(spacing);
  column->addWidget(details_, 1);
  column->addLayout(verbs);
  return column;
}

void PatientPicker::setTabOrders()
{
  const auto fields = details_->fields();
  QWidget* before = search_;
  for (QWidget* each :
       {static_cast<QWidget*>(list_), fields[0], fields[1], fields[2], static_cast<QWidget*>(open_),
        static_cast<QWidget*>(edit_), static_cast<QWidget*>(export_),
        static_cast<QWidget*>(archive_), static_cast<QWidget*>(archived_),
        static_cast<QWidget*>(table_), static_cast<QWidget*>(import_),
        static_cast<QWidget*>(cancel_), static_cast<QWidget*>(back_)}) {
    setTabOrder(before, each);
    before = each;
  }
}

void PatientPicker::refresh(const std::filesystem::path& beingRecorded)
{
  details_->keep();
  beingRecorded_ = beingRecorded;
  patients_ = savedPatients();
  shown_.clear();  // their indices are those of before
  search_->clear();
  showMatches();
  details_->readHistory(beingRecorded);
}

void PatientPicker::showMatches()
{
  details_->keep();
  const QString wanted = search_->text().trimmed();
  const SavedPatient* before = selected();
  const std::filesystem::path wasSelected = before ? before->file : std::filesystem::path();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    shown_.clear();
    int row = 0;
    for (std::size_t i = 0; i < patients_.size(); ++i) {
      const SavedPatient& each = patients_[i];
      if (each.record.isArchived && !archived_->isChecked()) continue;
      const QString found = QStringLiteral("%1\n%2\n%3")
                                .arg(nameOfPatient(each.patient), tagsText(each.record),
                                     QString::fromStdString(each.record.notes));
      if (!found.contains(wanted, Qt::CaseInsensitive)) continue;
      showLine(*new QListWidgetItem(list_), each);
      if (each.file == wasSelected) row = list_->count() - 1;
      shown_.push_back(i);
    }
    if (!shown_.empty()) list_->setCurrentRow(row);
  }
  open_->setEnabled(!shown_.empty());
  edit_->setEnabled(!shown_.empty());
  showSelected();
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
  if (const SavedPatient* patient = selected()) Q_EMIT openRequested(SavedPatient(*patient));
}

void PatientPicker::showSelected()
{
  const SavedPatient* patient = selected();
  archive_->setEnabled(patient != nullptr);
  export_->setEnabled(patient != nullptr && !transfer_->isBusy());
  archive_->setText(patient && patient->record.isArchived ? tr("Restore") : tr("Archive"));
  details_->show(patient ? std::optional(*patient) : std::nullopt);
}

void PatientPicker::show(const Result<void>& done, const QString& sentence)
{
  status_->setText(done ? sentence : dataText(done.error().message));
}

void PatientPicker::takeRecord(const SavedPatient& patient)
{
  for (std::size_t i = 0; i < patients_.size(); ++i) {
    if (patients_[i].file != patient.file) continue;
    patients_[i].record = patient.record;
    const auto row = std::find(shown_.begin(), shown_.end(), i);
    if (row != shown_.end()) showLine(*list_->item(int(row - shown_.begin())), patients_[i]);
  }
}

void PatientPicker::changeArchived()
{
  details_->keep();
  const SavedPatient* patient = selected();
  if (patient == nullptr) return;
  session::PatientRecord record = patient->record;
  record.isArchived = !record.isArchived;
  const QString name = nameOfPatient(patient->patient);
  const auto saved = session::savePatientRecord(record, patient->file);
  if (saved) {
    patients_[shown_[std::size_t(list_->currentRow())]].record = *saved;
    showMatches();
  }
  show(saved ? Result<void>() : Result<void>(saved.error()),
       record.isArchived ? tr("%1 is archived; nothing is deleted.").arg(name)
                         : tr("%1 is in the list again.").arg(name));
}

void PatientPicker::exportSelected()
{
  details_->keep();
  const SavedPatient* patient = selected();
  if (patient == nullptr) return;
  const QString place = QFileDialog::getExistingDirectory(this, tr("Folder for the export"));
  if (place.isEmpty()) return;
  const std::filesystem::path folder =
      std::filesystem::path(place.toStdString()) / patient->file.stem();
  const QString name = nameOfPatient(patient->patient);
  startTransfer(
      [folder, file = patient->file, about = patient->patient](
          const session::CopyProgress& progress,
          const std::stop_token& stop) -> Result<std::filesystem::path> {
        const auto done = session::exportPatient(file, insertionsOf(about), folder, progress, stop);
        if (!done) return done.error();
        return folder;
      },
      tr("Exporting %1: %2 %").arg(name),
      [name](const QString& copied) { return tr("%1 is exported to %2.").arg(name, copied); });
}

void PatientPicker::exportTable()
{
  details_->keep();
  const QString proposed = documentsFolder() + QStringLiteral("/patients-") +
                           QDate::currentDate().toString(Qt::ISODate) + QStringLiteral(".csv");
  const QString chosen = QFileDialog::getSaveFileName(this, tr("Table of all patients"), proposed,
                                                      tr("Tables (*.csv)"));
  if (chosen.isEmpty()) return;
  planning::RegistryFolders folders = planning::ownRegistryFolders();
  folders.beingRecorded = beingRecorded_;
  const auto notes = std::make_shared<QStringList>();
  startTransfer(
      [folders, notes, file = std::filesystem::path(chosen.toStdString())](
          const session::CopyProgress& progress,
          const std::stop_token& stop) -> Result<std::filesystem::path> {
        const auto registry = planning::patientRegistry(folders, progress, stop);
        if (!registry) return registry.error();
        const auto written = writeTable(file, registry->csv, planning::registryDictionaryCsv());
        if (!written) return written.error();
        for (const Sentence& note : registry->notes) *notes << dataText(note);
        return file;
      },
      tr("Reading plans and replaying insertions: %1 %"),
      [notes](const QString& file) {
        return tr("The table is in %1.").arg(file) + QLatin1Char(' ') +
               notes->join(QLatin1Char(' '));
      });
}

void PatientPicker::startTransfer(PatientTransfer::Copy copy, const QString& task,
                                  std::function<QString(const QString& place)> done)
{
  task_ = task;
  transferDone_ = std::move(done);
  cancel_->show();
  import_->setEnabled(false);
  table_->setEnabled(false);
  transfer_->start(std::move(copy));
  showSelected();
}

/// A transfer has ended.
void PatientPicker::showTransfer(const QString& sentence)
{
  cancel_->hide();
  import_->setEnabled(true);
  table_->setEnabled(true);
  showSelected();
  status_->setText(sentence);
}

void PatientPicker::importPatient()
{
  const QString place =
      QFileDialog::getExistingDirectory(this, tr("Folder of an exported patient"));
  if (place.isEmpty()) return;
  startTransfer(
      [place = place.toStdString()](const session::CopyProgress& progress,
                                    const std::stop_token& stop) {
        return session::importPatient(place, patientFolder(), sessionFolder(), progress, stop);
      },
      tr("Importing: %1 %"),
      [this](const QString&) {
        refresh(beingRecorded_);
        return tr("The patient is imported.");
      });
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
