// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Studies: made and run here, filtered, plotted and summarized; each insertion can be replayed.

#include <filesystem>

#include "gui/pages/Page.h"
#include "gui/pages/studies/StudyRunWork.h"
#include "gui/pages/studies/StudyWork.h"
#include "perilymph/study/StudySummary.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class EmptyPage;
class NewStudy;
class StatusLine;
class StudyDetails;
class StudyPanel;
class StudyPlot;
class SummaryTables;

/// The page of studies.
class StudiesPage : public Page {
  Q_OBJECT
public:
  explicit StudiesPage(QWidget* parent);

  /// The result of a study.
  Acceptance accepts(const std::filesystem::path& file) const override
  {
    return file.extension() == ".sqlite" ? Acceptance::always : Acceptance::none;
  }
  /// Opens a result without asking.
  void open(const std::filesystem::path& file) override;
  /// Leaves the form of a new study, or else ends reading or running. False if there was nothing.
  bool cancel() override;
  bool isBusy() const override { return work_.isBusy() || running_.isBusy(); }
  /// The opened study; null before.
  const StudyWork::Columns& columns() const { return columns_; }
  StudyPanel& panel() { return *panel_; }
  StudyPlot& plot() { return *plot_; }
  /// The summary of the shown insertions; null until it was computed.
  const std::shared_ptr<const study::StudySummary>& summary() const { return summary_; }
  /// Folder of the study that was last run here; empty before.
  const std::filesystem::path& folder() const { return folder_; }

  /// Writes the tables of the shown insertions as CSV into a folder.
  Result<void> writeInto(const std::filesystem::path& folder) const;

private:
  QWidget* addPlot();
  QWidget* addFoot();
  void connectWork();
  void ask();
  void askNew();
  void leaveForm();
  void startStudy(const StudyDraft& draft);
  void takeStored(const StoredStudy& study);
  void resume();
  bool endWork();
  void showRun(std::size_t done, std::size_t all, double left_s);
  void showEnd(const StoredStudy& study);
  void showStudy(const StudyWork::Columns& columns, const std::filesystem::path& file);
  void showRows();
  void summarize();
  void showSummary();
  void choose(std::uint32_t row);
  void runAgain();
  void save();
  void showMessage(const QString& sentence, bool isError = false);
  void showBusy();

  StudyWork work_;
  StudyRunWork running_;
  Background summarizing_;
  StudyWork::Columns columns_;
  std::shared_ptr<const study::StudySummary> summary_;
  std::filesystem::path file_, folder_;

  QStackedWidget* stages_;
  EmptyPage* empty_;
  NewStudy* form_;
  StudyPanel* panel_;
  StudyPlot* plot_;
  SummaryTables* tables_;
  StudyDetails* details_;
  QLabel* title_;
  QLabel* count_;
  QPushButton* export_;
  QProgressBar* progress_;
  QPushButton *continue_, *cancel_;
  StatusLine* status_;
};

}  // namespace perilymph::gui
