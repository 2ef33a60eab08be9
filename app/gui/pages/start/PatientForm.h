// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Form for a patient's measures: A, B and H from CT, or three lengths of the scala tympani.

#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/electrode/ArrayDesign.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class Choice;
class CochleaStore;
class DerivedMeasures;
class LandmarkDrawing;
class PopulationField;

/// Input of one patient. Errors are shown beside their fields, and invalid input cannot be
/// submitted.
class PatientForm : public QWidget {
  Q_OBJECT
public:
  PatientForm(std::shared_ptr<CochleaStore> cochleae, QWidget* parent);

  /// Begins a new patient with empty fields.
  void beginNew();
  /// Shows a saved patient, whose file is replaced when it is submitted.
  void beginEditing(const anatomy::Patient& patient, const std::filesystem::path& file);
  /// The file of the patient that is edited; empty for a new one.
  const std::optional<std::filesystem::path>& edited() const { return edited_; }

  anatomy::Patient patient() const;
  /// Shows why the patient could not be used; hidden if empty.
  void showError(const QString& sentence);

Q_SIGNALS:
  void patientGiven(const perilymph::anatomy::Patient& patient);
  void leaveRequested();
  /// The user requests the measures from a CT, under the typed code.
  void ctRequested(const QString& code);

private:
  QWidget* addForm();
  QWidget* addExplanations();
  QWidget* addBasalTurn();
  QWidget* addLengths();
  void connectFields();
  void setTabOrders();
  void setPatient(const anatomy::Patient& patient);
  void showState();
  void submit();
  /// The fields of the chosen measures.
  std::vector<PopulationField*> fields() const;
  bool isComplete() const;

  std::optional<std::filesystem::path> edited_;
  anatomy::Patient shown_;  ///< As setPatient() was given it, with the errors of its measures.
  std::optional<electrode::ArrayDesign> array_;  ///< An example for the coverage.
  QLabel* title_;
  QLineEdit* label_;
  QLabel* labelError_;
  Choice* right_;
  Choice* left_;
  Choice* byBasalTurn_;
  Choice* byLengths_;
  QStackedWidget* numbers_;
  PopulationField *a_, *b_, *h_, *length_, *width_, *height_;
  QLabel* warning_;
  QLabel* error_;
  QPushButton* back_;
  QPushButton* use_;
  LandmarkDrawing* landmarks_;
  DerivedMeasures* derived_;
};

}  // namespace perilymph::gui
