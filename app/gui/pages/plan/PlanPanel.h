// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is planned: patient, arrays, friction and number of draws; saved plans.

#include <QWidget>
#include <optional>
#include <vector>

#include "gui/setup/PlanStore.h"

class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class CheckBox;
class Selector;

/// Asks for plans; it computes nothing.
class PlanPanel : public QWidget {
  Q_OBJECT
public:
  explicit PlanPanel(QWidget* parent);

  /// Reads patients and plans from the disk again.
  void refresh();
  /// Selects a patient, who need not be saved.
  void setPatient(const anatomy::Patient& patient);
  /// The selected patient; empty if none has A and B.
  const std::optional<anatomy::Patient>& patient() const { return patient_; }
  /// Patient, arrays, friction and draws as chosen.
  planning::PlanRequest request() const;
  /// Shows the request of a plan.
  void showPlan(const StoredPlan& plan);
  /// Shows the progress of a computation from 0 to 1; none if idle.
  void showProgress(std::optional<double> fraction);

  /// As its button.
  void compute();

Q_SIGNALS:
  /// A plan can be computed: there are a patient and an array, and none is computed now.
  void readyChanged(bool isReady);
  void patientChosen();
  void computeRequested();
  void cancelRequested();
  void planChosen(const perilymph::gui::StoredPlan& plan);

private:
  struct Row {
    CheckBox* box;
    std::string array;
  };
  void addPatient(QVBoxLayout& column);
  void addArrays(QVBoxLayout& column);
  void addPlans(QVBoxLayout& column);
  void addFoot(QVBoxLayout& column);
  void choosePatient(const QString& key);
  void listPlans();
  void check(bool isChecked);
  void showState();

  std::vector<anatomy::Patient> patients_;
  std::optional<anatomy::Patient> patient_;
  std::vector<StoredPlan> plans_;
  std::vector<Row> arrays_;
  bool isBusy_ = false;

  Selector* patientList_;
  Selector* planList_;
  Selector* friction_;
  Selector* draws_;
  QPushButton* compute_;
  QPushButton* cancel_;
  QProgressBar* progress_;
};

}  // namespace perilymph::gui
