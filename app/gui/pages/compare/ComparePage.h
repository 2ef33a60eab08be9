// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Comparison of several recorded insertions: curves with a common cursor, and tables of insertions and
// of groups.

#include <filesystem>
#include <vector>

#include "gui/pages/Page.h"
#include "gui/run/Background.h"
#include "perilymph/analysis/ComparisonGroups.h"
#include "perilymph/analysis/Score.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class ComparisonPlot;
class EmptyPage;
class GroupsTable;
class RunsTable;
class StatusLine;

/// The comparison page.
class ComparePage : public Page {
  Q_OBJECT
public:
  explicit ComparePage(QWidget* parent);

  /// Reads recordings in the background and shows them; requests to be shown.
  void compare(const std::vector<std::filesystem::path>& files);
  bool isBusy() const override { return reading_.isBusy(); }
  bool cancel() override;
  const std::vector<analysis::ComparedInsertion>& runs() const { return runs_; }

  /// Writes tables, curves and events as CSV, the figure as SVG and PNG, into a folder.
  Result<void> writeInto(const std::filesystem::path& folder) const;

private:
  QWidget* addRuns();
  void showRuns(std::vector<analysis::ComparedInsertion> runs);
  /// The published measurements, if one of the runs has their conditions.
  const analysis::Reference* comparedWith() const;
  analysis::CurveAxis axis() const;
  const std::vector<analysis::GroupKey>& keys() const;
  /// Shows curves and table of the chosen axis and groups.
  void showContent();
  /// Sets the cursor to the peak of the first insertion, without ribs.
  void placeCursor();
  /// Warns of groups whose insertions differ in more than chance.
  void showMixed();
  void showCursor();
  void showScore();
  void save();

  std::vector<analysis::ComparedInsertion> runs_;
  std::vector<Result<analysis::InsertionScore>> scores_;
  std::vector<analysis::InsertionGroup> groups_;
  Result<analysis::Reference> published_;
  QStackedWidget* stack_;
  EmptyPage* empty_;
  ComparisonPlot* plot_ = nullptr;
  RunsTable* runsTable_ = nullptr;
  GroupsTable* groupsTable_ = nullptr;
  QComboBox *axis_ = nullptr, *grouping_ = nullptr;
  QLabel *legend_ = nullptr, *score_ = nullptr, *mixed_ = nullptr, *method_ = nullptr;
  StatusLine* status_ = nullptr;
  QPushButton* save_ = nullptr;
  Background reading_;
};

}  // namespace perilymph::gui
