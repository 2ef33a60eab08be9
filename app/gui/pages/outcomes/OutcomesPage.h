// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The page Outcomes: what plans predicted and what came true, over all patients.

#include <QTableWidget>

#include "gui/pages/Page.h"
#include "gui/pages/outcomes/OutcomesWork.h"
#include "gui/run/Background.h"

class QLabel;
class QStackedWidget;

namespace perilymph::gui {

class DrawingView;
class EmptyPage;
class StatusLine;

/// A row for each ear, predicted against measured depth, coverage of the bands, percentiles.
class OutcomesPage : public Page {
  Q_OBJECT
public:
  explicit OutcomesPage(QWidget* parent);

  /// Reads the records again.
  void onShown() override;
  void onChosenAgain() override { onShown(); }
  bool isBusy() const override { return background_.isBusy(); }
  bool cancel() override;

private:
  QWidget* addContent();
  void show(const AllOutcomes& all);
  void showRows(const AllOutcomes& all);
  void showCoverage(const outcome::ClinicOutcomes& clinic);
  void save();

  Background background_;
  outcome::ClinicOutcomes clinic_;
  QStackedWidget* stages_;
  EmptyPage* empty_;
  QTableWidget *rows_, *coverage_;
  DrawingView *depths_, *percentiles_;
  StatusLine* status_;
};

}  // namespace perilymph::gui
