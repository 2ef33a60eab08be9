// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The panel's list of saved patients, and the button that saves the current one.

#include <QWidget>
#include <optional>

#include "gui/setup/PatientLibrary.h"
#include "gui/setup/Setup.h"

class QLabel;
class QPushButton;

namespace perilymph::gui {

class Selector;
class VersionQuestion;

/// Opens saved patients, and saves the numbers of the setup.
class SavedPatientRow : public QWidget {
  Q_OBJECT
public:
  explicit SavedPatientRow(QWidget* parent);

  /// Follows the setup, and reads the patient folder again.
  void show(const Setup& setup);

Q_SIGNALS:
  /// The user selected a saved patient.
  void patientChosen(const perilymph::anatomy::Patient& patient);
  /// The user requests a search of all saved patients, or a new one.
  void allPatientsRequested();
  void newPatientRequested();
  /// The numbers are to be saved under another code.
  void otherCodeWanted();

private:
  void choose(const QString& value);
  /// Asks before other numbers become a new version of a saved patient.
  void askToSave();
  void save(const anatomy::Patient& patient);
  void showState();

  anatomy::Patient patient_;
  bool isScaled_ = false;  ///< The cochlea is a patient's.
  std::optional<SavedPatient> saved_;
  QString shown_;  ///< The selected entry.
  Selector* list_;
  QPushButton* save_;
  VersionQuestion* question_;
  QLabel* status_;
};

}  // namespace perilymph::gui
