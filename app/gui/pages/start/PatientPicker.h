// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The saved patients: a list with a search, archive, export and import; beside it the selected one.

#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "gui/pages/start/PatientTransfer.h"
#include "gui/setup/PatientHistory.h"

class QLabel;
class QLayout;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace perilymph::gui {

class CheckBox;
class PatientDetails;

/// Selection of a saved patient, to open or to edit, and of what belongs to one.
class PatientPicker : public QWidget {
  Q_OBJECT
public:
  explicit PatientPicker(QWidget* parent);

  /// Reads patients, plans and recordings again, and clears the search.
  ///
  /// @param beingRecorded  A recording that is not finished; it may be empty.
  void refresh(const std::filesystem::path& beingRecorded);

Q_SIGNALS:
  void openRequested(const perilymph::gui::SavedPatient& patient);
  void editRequested(const perilymph::gui::SavedPatient& patient);
  /// An entry of a patient's history was opened.
  void entryRequested(const perilymph::gui::HistoryEntry& entry);
  void leaveRequested();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QLayout* addList();
  QLayout* addSelected();
  QPushButton* addButton(const QString& text, const char* name);
  void setTabOrders();
  void showMatches();
  const SavedPatient* selected() const;
  void openSelected();
  void showSelected();
  void takeRecord(const SavedPatient& patient);
  void changeArchived();
  void exportSelected();
  void exportTable();
  void importPatient();
  void show(const Result<void>& done, const QString& sentence);
  /// @param task  "Importing: %1 %"
  /// @param done  The sentence about what was copied to a place.
  void startTransfer(PatientTransfer::Copy copy, const QString& task,
                     std::function<QString(const QString& place)> done);
  void showTransfer(const QString& sentence);

  std::vector<SavedPatient> patients_;
  std::vector<std::size_t> shown_;  ///< Indices of `patients_`, one a row.
  std::filesystem::path beingRecorded_;
  QLineEdit* search_;
  QListWidget* list_;
  PatientDetails* details_;
  QLabel* status_;
  CheckBox* archived_;
  QPushButton *import_, *table_, *open_, *edit_, *archive_, *export_, *back_, *cancel_;
  PatientTransfer* transfer_;
  QString task_;  ///< What is copied, with a place for its percentage.
  std::function<QString(const QString&)> transferDone_;
};

}  // namespace perilymph::gui
