// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Results of a study: filtered and plotted; each insertion can be replayed.

#include <filesystem>

#include "gui/pages/Page.h"
#include "gui/pages/studies/StudyWork.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class EmptyPage;
class StatusLine;
class StudyDetails;
class StudyPanel;
class StudyPlot;

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
  /// Ends reading or running. False if there was nothing.
  bool cancel() override;
  bool isBusy() const override { return work_.isBusy(); }
  /// The opened study; null before.
  const StudyWork::Columns& columns() const { return columns_; }
  StudyPanel& panel() { return *panel_; }
  StudyPlot& plot() { return *plot_; }

private:
  QWidget* addPlot();
  void ask();
  void showStudy(const StudyWork::Columns& columns, const std::filesystem::path& file);
  void showRows();
  void choose(std::uint32_t row);
  void runAgain();
  void say(const QString& sentence, bool isError = false);
  void setBusy(bool isBusy);

  StudyWork work_;
  StudyWork::Columns columns_;
  std::filesystem::path file_;

  QStackedWidget* stages_;
  EmptyPage* empty_;
  StudyPanel* panel_;
  StudyPlot* plot_;
  StudyDetails* details_;
  QLabel* title_;
  QLabel* count_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  StatusLine* status_;
};

}  // namespace perilymph::gui
