// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// List of the saved patients, with a search, tags, archive, export and import.

#include <QWidget>
#include <vector>

#include "gui/setup/PatientLibrary.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace perilymph::gui {

class CheckBox;

/// Selection of a saved patient, to open or to edit.
class PatientPicker : public QWidget {
  Q_OBJECT
public:
  explicit PatientPicker(QWidget* parent);

  /// Reads the patient folder again, and forgets the search.
  void refresh();

Q_SIGNALS:
  void openAsked(const perilymph::gui::SavedPatient& patient);
  void editAsked(const perilymph::gui::SavedPatient& patient);
  void leaveAsked();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void showMatches();
  const SavedPatient* selected() const;
  void openSelected();
  void showRecord();
  void keepTags();
  void changeArchived();
  void exportSelected();
  void importPatient();
  void show(const Result<Done>& done, const QString& sentence);

  std::vector<SavedPatient> patients_;
  std::vector<std::size_t> shown_;  ///< Indices of `patients_`, one a row.
  QLineEdit* search_;
  QListWidget* list_;
  QLabel* status_;
  QLineEdit* tags_;
  CheckBox* archived_;
  QPushButton *open_, *edit_, *archive_, *export_;
};

}  // namespace perilymph::gui
