// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The page Plan: electrode arrays compared in one patient's cochlea before surgery.

#include <QElapsedTimer>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "gui/pages/Page.h"
#include "gui/pages/plan/PlanReportWork.h"
#include "gui/pages/plan/PlanWork.h"
#include "gui/report/ReportSending.h"

class QHBoxLayout;
class QPushButton;
class QStackedWidget;

namespace perilymph::gui {

class EmptyPage;
class PlanHeader;
class PlanList;
class PlanNotes;
class PlanPanel;
class PlanView;
class StatusLine;

/// Makes a plan, lists its arrays with their bands, and carries one of them to an insertion.
class PlanPage : public Page {
  Q_OBJECT
public:
  explicit PlanPage(QWidget* parent);

  /// Plans for a patient with A and B, as measured in a CT; requests to be shown.
  void planFor(const anatomy::Patient& patient);
  /// The folder of a plan, or its plan.json.
  Acceptance accepts(const std::filesystem::path& file) const override;
  /// Opens a saved plan. A computation ends, of which is kept what is done.
  void open(const std::filesystem::path& folder) override;
  /// Reads patients and plans from the disk again.
  void onShown() override;
  /// Leaves the view of an array, or ends the computation, of which is kept what is done. False if
  /// there was neither.
  bool cancel() override;
  /// Writes the report of the plan that is shown.
  void writeReport(const ReportPlace& place);
  bool isBusy() const override { return work_.isBusy(); }
  /// The plan that is shown; null before.
  const PlanWork::SharedPlan& plan() const { return plan_; }
  /// A scenario that defines everything that is neither drawn nor chosen; "surgery-flex28" unless
  /// set.
  void setScenario(std::string scenario)
  {
    scenario_ = std::move(scenario);
    resolution_.reset();  // its own
  }
  /// Where the CT of a series is, as far as it is open.
  void setCtPlaces(CtPlaces places) { ctPlaces_ = std::move(places); }
  /// The approach of a patient's cochlea in the CT that is open; empty for any other patient, whose plans have
  /// that of the scenario.
  using ApproachSource =
      std::function<std::optional<anatomy::Approach>(const anatomy::Patient& patient)>;
  void setApproachSource(ApproachSource source) { approachSource_ = std::move(source); }
  /// Shows the approach of the plan, or of the one to be made.
  void showApproach();
  PlanList& list() { return *list_; }
  PlanView& view() { return *view_; }

private:
  QWidget* addPlan();
  QWidget* addArrays();
  void addVerbs(QHBoxLayout& row);
  void openArrays();
  void insertArray();
  void askReport();
  void send(const std::string& pdf, const ReportIdentity& identity);
  bool leaveArrays();
  void showVerbs();
  void connectPanel();
  void connectWork();
  void compute();
  /// The approach of the next plan of a patient: that of the CT, else that of the plan shown, if any.
  std::optional<anatomy::Approach> wantedApproach(const anatomy::Patient& patient) const;
  bool stop();
  void openStored(const StoredPlan& stored);
  void showPlan(const PlanWork::SharedPlan& plan, const StoredPlan& stored);
  void showProgress(std::size_t done, std::size_t all);
  /// "about 4 min left at most", once there is enough to go by; else empty.
  QString timeLeft(std::size_t done, std::size_t all);
  void endProgress();
  /// Text of the page before the first bands.
  void showEmpty();
  void discardPlan();
  void showMessage(const QString& sentence, bool isError = false);

  PlanWork work_;
  PlanReportWork reporting_;
  PlanWork::SharedPlan plan_;
  std::filesystem::path folder_;  ///< Folder of `plan_`.
  std::string madeUtc_;           ///< When `plan_` was made.
  std::string scenario_;
  QElapsedTimer sinceFirst_;   ///< Begins with the first progress of a computation.
  std::size_t firstDone_ = 0;  ///< Insertions that were done then.
  QString progress_;           ///< What is said of the computation; empty without one.
  CtPlaces ctPlaces_;
  ApproachSource approachSource_;
  std::optional<planning::Resolution> resolution_ = planning::Resolution{};
  PlanPanel* panel_;
  QStackedWidget* stages_;
  EmptyPage* empty_;
  PlanHeader* head_;
  PlanList* list_;
  PlanView* view_;
  QPushButton *open_, *insert_, *report_, *send_, *back_;
  PlanNotes* notes_;
  StatusLine* status_;
};

}  // namespace perilymph::gui
