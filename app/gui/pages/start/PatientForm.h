// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Form for a patient's numbers from CT: three lengths, or A, B and H.

#include <QWidget>

#include "perilymph/anatomy/Patient.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class Choice;
class PopulationField;

/// Input of one patient. Errors are shown beside their fields, and invalid input cannot be
/// submitted.
class PatientForm : public QWidget {
  Q_OBJECT
public:
  explicit PatientForm(QWidget* parent);

  void setPatient(const anatomy::Patient& patient);
  anatomy::Patient patient() const;
  /// Shows why the patient could not be used; hidden if empty.
  void showError(const QString& sentence);

Q_SIGNALS:
  void patientGiven(const perilymph::anatomy::Patient& patient);
  void leaveAsked();

private:
  QWidget* addLengths();
  QWidget* addBasalTurn();
  void showState();
  bool isAcceptable() const;

  QLineEdit* label_;
  Choice* right_;
  Choice* left_;
  Choice* byLengths_;
  Choice* byBasalTurn_;
  QStackedWidget* numbers_;
  PopulationField *length_, *width_, *height_, *a_, *b_, *h_;
  QLabel* error_;
  QPushButton* use_;
};

}  // namespace perilymph::gui
