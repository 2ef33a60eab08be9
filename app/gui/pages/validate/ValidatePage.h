// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Validation against the published experiment: live figures and verdicts.

#include <optional>

#include "gui/pages/Page.h"
#include "gui/pages/validate/ValidationWork.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace perilymph::gui {

class Choice;
class DrawingView;
class StatusLine;

/// Repeats the experiment on request, and lists which expectations were met.
class ValidatePage : public Page {
  Q_OBJECT
public:
  explicit ValidatePage(QWidget* parent);

  void start();
  bool isBusy() const override { return work_.isRunning(); }
  bool cancel() override;
  /// The last complete run; empty before.
  const std::optional<validation::ValidationResult>& result() const { return result_; }

private:
  enum class Shown { simulation, experiment, difference };

  QWidget* addColumn();
  QWidget* addFigures();
  void showFigure();
  void showState();
  void showVerdicts();
  void finish(const std::optional<validation::ValidationResult>& result, const QString& error);
  void save();
  /// The typed number of insertions; empty if it is not allowed.
  std::optional<int> typedRuns() const;

  Result<ValidationBasis> basis_;
  ValidationWork work_;
  std::optional<validation::ValidationResult> result_;
  validation::ValidationResult sofar_;
  Shown shown_ = Shown::experiment;

  QLineEdit* runs_ = nullptr;
  QLabel* runsError_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* save_ = nullptr;
  QProgressBar* progress_ = nullptr;
  StatusLine* status_ = nullptr;
  QLabel* headline_ = nullptr;
  QGridLayout* verdicts_ = nullptr;
  Choice *simulation_ = nullptr, *experiment_ = nullptr, *difference_ = nullptr;
  DrawingView* drawing_ = nullptr;
};

}  // namespace perilymph::gui
