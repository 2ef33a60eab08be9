// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Tags, notes, measures and history of one patient.

#include <QWidget>
#include <array>
#include <map>
#include <optional>

#include "gui/run/Background.h"
#include "gui/setup/PatientHistory.h"

class QLabel;
class QLineEdit;

namespace perilymph::gui {

class ElidedLabel;
class MeasureVersionList;
class NotesField;
class PatientHistoryList;

/// The selected patient. Tags and notes are saved when their field loses the focus and when another
/// patient or page is shown; what could not be saved stays in the field.
class PatientDetails : public QWidget {
  Q_OBJECT
public:
  explicit PatientDetails(QWidget* parent);

  /// Shows a patient, after those of the one before were saved; nobody if empty.
  void show(const std::optional<SavedPatient>& patient);
  /// Reads scans, plans and insertions again.
  ///
  /// @param beingRecorded  A recording that is not finished; it may be empty.
  void readHistory(const std::filesystem::path& beingRecorded);
  /// Saves what was typed.
  void keep();
  /// Tags, notes and history, in the order of Tab.
  std::array<QWidget*, 3> fields() const;

Q_SIGNALS:
  /// Tags or notes were saved.
  void recordKept(const perilymph::gui::SavedPatient& patient);
  void said(const QString& sentence);
  /// An entry of the history was opened.
  void opened(const perilymph::gui::HistoryEntry& entry);

private:
  /// What of a patient's files was changed after the program wrote it; empty if nothing was.
  static QString handChanges(const SavedPatient& patient);
  session::PatientRecord typed() const;
  void showHistory();
  /// After a refused save: the record of another program, with what was typed here.
  void takeOthersChange(session::PatientRecord& record);
  /// Adds plans and insertions to the record that it does not name yet.
  void noteWork(const std::vector<HistoryEntry>& entries);

  std::optional<SavedPatient> patient_;
  bool isMerged_ = false;  ///< The fields hold what another program saved, too.
  /// What could not be saved, by patient's file.
  std::map<std::filesystem::path, session::PatientRecord> unsaved_;
  std::optional<PatientWork> work_;  ///< Empty until it is read.
  Background background_;
  ElidedLabel* name_;
  QLineEdit* tags_;
  NotesField* notes_;
  MeasureVersionList* versions_;
  QLabel* empty_;
  PatientHistoryList* history_;
};

}  // namespace perilymph::gui
