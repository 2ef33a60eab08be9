// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The page Outcome: the implanted array found in a CT after surgery, beside its plan.

#include <QElapsedTimer>
#include <QPointer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "gui/pages/Page.h"
#include "gui/pages/ct/CtStudy.h"
#include "gui/pages/ct/CtWork.h"
#include "gui/pages/outcome/FoundHistory.h"
#include "gui/pages/outcome/OutcomeWork.h"
#include "gui/pages/outcome/PlannedEar.h"
#include "gui/report/ReportSaving.h"
#include "gui/run/Background.h"
#include "gui/run/InsertionControl.h"
#include "perilymph/outcome/OutcomeText.h"

class QStackedWidget;

namespace perilymph::gui {

class ArchiveView;
class EarQuestion;
class EmptyPage;
class OutcomePanel;
class OutcomeView;
enum class OutcomeExport;

/// Finds the contacts of a patient's array, shows them beside plan and insertion by hand, and keeps them in
/// the patient's record.
class OutcomePage : public Page {
  Q_OBJECT
public:
  /// @param control  Whose recording is not read while it is written.
  OutcomePage(const InsertionControl& control, QWidget* parent);

  /// Opens a folder or a file with a CT after surgery.
  void open(const std::filesystem::path& path) override;
  Acceptance accepts(const std::filesystem::path& file) const override;
  void onShown() override;
  bool isBusy() const override;
  bool cancel() override;
  /// Undo and redo of moved contacts.
  bool takeKey(const QKeyEvent& event) override;
  /// An outcome that is not saved in the record, or answers of the surgeon.
  std::optional<Unfinished> unfinished() const override;
  void endUnfinished() override;

  /// Replaces what the page computes with.
  void setFinder(OutcomeFinder finder) { work_.setFinder(std::move(finder)); }
  /// Where the patient of the plan that is shown is asked for.
  void setPlannedPatient(std::function<std::optional<anatomy::Patient>()> planned)
  {
    plannedPatient_ = std::move(planned);
  }
  CtStudy& study() { return study_; }
  /// What was found; null before.
  const std::shared_ptr<const outcome::FoundArray>& found() const { return history_.now().found; }
  /// Finds the ear, if it is not known, and the contacts.
  void find();
  /// Saves what was found as a new version in the patient's record.
  void save();
  void exportTo(OutcomeExport kind, const std::filesystem::path& file);
  void writeReport(const ReportPlace& place);
  /// Requests to be shown with an outcome that is saved in a patient's record.
  /// @param place  Its place in the record.
  void openSaved(const std::filesystem::path& patient, std::size_t place);
  /// Reads the list of archives again.
  void showServers();

Q_SIGNALS:
  /// The archives in the settings are to be shown.
  void serversRequested();
  /// Something is to be done that ends the outcome shown: a question comes first if it is not saved.
  void endingRequested(const QString& action, const std::function<void()>& act);
  /// What was not saved is.
  void kept();

private:
  void connectCt();
  void connectPanel();
  void connectWork();
  void read(const std::filesystem::path& path, const std::string& series);
  /// Does something that takes another CT in place of the one shown.
  void leaveCt(const std::function<void()>& act);
  void showCt(imaging::LoadedCt&& loaded);
  void showArchive(bool isShown);
  void beginTask(const QString& task);
  void showProgress(double fraction);
  void showStep(OutcomeStep step, double fraction);
  void choosePatient();
  /// Chooses the saved patient of the insertion or of the plan that is shown; none where both are of different ears.
  void takePatientOver();
  /// Forgets plan and outcome of a patient; the CT stays.
  void leavePatient();
  /// Ends a search, and a question that it led to.
  void endSearch();
  void openVersion(std::size_t place);
  /// Reads plan and insertion of the patient and the array; proposes an array where none is chosen.
  /// @param isToFind  Finds the contacts then, if there are none.
  void readPlanned(bool isToFind);
  void findEar();
  void acceptEar(const OutcomeWork::SharedEar& ear);
  /// Shows the planes of the ear, so large that contacts are apart.
  void showEar();
  /// Shows the planes of the ear of a saved outcome, whose contacts stay as they were saved.
  void showReopened(const OutcomeWork::SharedEar& ear);
  void findContacts();
  /// Finds the others around contacts that were moved.
  void findAround();
  void moveContact(int number, const Eigen::Vector3d& point_P);
  void step(void (FoundHistory::*way)());
  void leaveFound();
  void showFound();
  void askExport(OutcomeExport kind);
  void askReport();
  std::optional<EarlierCt> earlierCt() const;
  outcome::OutcomeContent content() const;
  /// Why the plan is no prediction, a sentence; empty if it is one, or if there is none.
  QString planDoubt() const;
  /// The day of surgery as far as it is known: "2026-11-20"; else empty.
  std::string surgeryDay() const;
  /// Why what was found can be of no ear, a sentence; empty if it can.
  QString obstacle() const;

  const InsertionControl& control_;
  std::function<std::optional<anatomy::Patient>()> plannedPatient_;
  CtStudy study_;
  CtWork ct_, thumbnails_;
  OutcomeWork work_;
  Background planning_;
  ReportSaving saving_;
  imaging::CtSeriesList list_;
  std::string wanted_;          ///< Series that a saved outcome was found in, while it is read.
  std::string series_;          ///< Series of what was found.
  std::string acquired_;        ///< Day of the CT that is shown, as it states it; else empty.
  OutcomeWork::SharedEar ear_;  ///< In the CT that is shown, joined to the patient; else null.
  QString earNote_;             ///< Why the CT before surgery was not used.
  std::string searched_;        ///< Array that is looked for; empty if none is.
  bool isReopened_ = false;     ///< The ear of a saved outcome is looked for, or its CT read.
  QPointer<EarQuestion> question_;
  FoundHistory history_;
  PlannedEar planned_;
  std::string planNumber_;  ///< That a saved outcome states; empty: the newest plan before surgery.
  std::string plannedFor_;  ///< Day of surgery for which the plan was chosen.
  bool isSaved_ = true;
  bool hadPatient_ = false;    ///< Answers of the form are of a patient.
  outcome::Surgery answered_;  ///< What the form had when it changed last.
  std::string answeredDay_;
  QString task_;
  QElapsedTimer since_;
  double shownFraction_ = 0.0;
  OutcomePanel* panel_;
  QStackedWidget* stages_;
  EmptyPage* empty_;
  OutcomeView* view_;
  ArchiveView* archive_;
};

}  // namespace perilymph::gui
