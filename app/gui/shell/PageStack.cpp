// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/PageStack.h"

#include <filesystem>
#include <vector>

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/pages/start/StartPage.h"
#include "gui/pages/studies/StudiesPage.h"
#include "gui/pages/validate/ValidatePage.h"
#include "gui/parts/DataText.h"
#include "gui/setup/PatientSetup.h"
#include "gui/shell/FileDrop.h"
#include "gui/shell/WindowTitle.h"

namespace perilymph::gui {

PageStack::PageStack(InsertPage& insert, QWidget* parent)
    : QStackedWidget(parent),
      insert_(insert),
      start_(new StartPage(insert.control().cochleae(), this)),
      ct_(new CtPage(this)),
      plan_(new PlanPage(this)),
      compare_(new ComparePage(this)),
      validate_(new ValidatePage(this)),
      sessions_(new SessionsPage(this)),
      studies_(new StudiesPage(this))
{
  // in the order of Page
  for (QWidget* page : {static_cast<QWidget*>(start_), static_cast<QWidget*>(ct_),
                        static_cast<QWidget*>(plan_), static_cast<QWidget*>(&insert_),
                        static_cast<QWidget*>(compare_), static_cast<QWidget*>(validate_),
                        static_cast<QWidget*>(sessions_), static_cast<QWidget*>(studies_)})
    addWidget(page);
  setCurrentWidget(&insert_);
  connectPages();
}

void PageStack::connectPages()
{
  connectStart();
  connectRecordings();
  connect(ct_, &CtPage::setupChosen, this, [this](const Setup& setup) {
    Q_EMIT setupChosen(setup, SetupOrigin::Kind::own, InsertPage::AfterLoading::rest);
  });
  connect(plan_, &PlanPage::insertAsked, this,
          [this](const Setup& setup, const PlannedForce& planned) {
            insert_.setPlan(planned);
            Q_EMIT setupChosen(setup, SetupOrigin::Kind::own, InsertPage::AfterLoading::rest);
          });
  connect(ct_, &CtPage::planAsked, this, [this](const anatomy::Patient& patient) {
    plan_->planFor(patient);
    Q_EMIT pageAsked(Page::plan);
  });
}

void PageStack::connectStart()
{
  using AfterLoading = InsertPage::AfterLoading;
  connect(start_, &StartPage::setupChosen, this,
          [this](const Setup& setup, SetupOrigin::Kind kind, bool isWatched) {
            Q_EMIT setupChosen(setup, kind, isWatched ? AfterLoading::insert : AfterLoading::rest);
          });
  connect(start_, &StartPage::continueAsked, this, [this] { Q_EMIT pageAsked(Page::insert); });
  connect(start_, &StartPage::replayAsked, this, &PageStack::replayAsked);
  connect(start_, &StartPage::scansAsked, this, [this] { Q_EMIT pageAsked(Page::ct); });
  connect(start_, &StartPage::planAsked, this, [this](const std::filesystem::path& folder) {
    Q_EMIT pageAsked(Page::plan);
    plan_->openPlan(folder);
  });
  connect(start_, &StartPage::allRecordingsAsked, this,
          [this] { Q_EMIT pageAsked(Page::sessions); });
  connect(&insert_, &InsertPage::allPatientsAsked, this, [this] {
    Q_EMIT pageAsked(Page::start);
    start_->showPatients();
  });
  connect(&insert_, &InsertPage::newPatientAsked, this, [this] {
    Q_EMIT pageAsked(Page::start);
    start_->showNewPatient();
  });
}

void PageStack::connectRecordings()
{
  connect(sessions_, &SessionsPage::replayAsked, this, &PageStack::replayAsked);
  connect(studies_, &StudiesPage::replayAsked, this, &PageStack::replayAsked);
  connect(sessions_, &SessionsPage::referenceRead, &insert_, &InsertPage::setReference);
  connect(sessions_, &SessionsPage::compareAsked, this,
          [this](const std::vector<std::filesystem::path>& files) {
            Q_EMIT pageAsked(Page::compare);
            compare_->compare(files);
          });
  connect(compare_, &ComparePage::recordingsAsked, this,
          [this] { Q_EMIT pageAsked(Page::sessions); });
  connect(&insert_, &InsertPage::replayFailed, this, &PageStack::showSessionsError);
  auto* drop = new FileDrop(parentWidget());
  connect(drop, &FileDrop::recordingDropped, this, &PageStack::replayAsked);
  connect(drop, &FileDrop::patientDropped, this, &PageStack::openPatient);
}

void PageStack::openPatient(const std::filesystem::path& file)
{
  const auto patient = anatomy::loadPatient(file);
  if (!patient) return refused(dataText(patient.error().message));
  const auto setup = setupOfPatient(*patient);
  if (!setup) return refused(dataText(setup.error().message));
  Q_EMIT setupChosen(*setup, SetupOrigin::Kind::own, InsertPage::AfterLoading::rest);
}

void PageStack::showPage(Page page)
{
  if (this->page() == Page::insert && page != Page::insert) insert_.leaveSight();
  setCurrentIndex(static_cast<int>(page));
  if (page == Page::start) start_->showCards({currentWork(insert_), insert_.control().recording()});
  if (page == Page::ct) showInsertionInCt();
  if (page == Page::plan) plan_->refresh();
  if (page != Page::sessions) return;
  sessions_->refresh(insert_.control().recording(), insert_.control().isRunning());
  sessions_->setFocus();
}

void PageStack::showInsertionInCt()
{
  const InsertionControl& control = insert_.control();
  if (const auto scala = control.sharedAnatomy())
    ct_->showInsertion(control.scenario(), *scala, control.now());
}

bool PageStack::cancel()
{
  switch (page()) {
    case Page::ct:
      return ct_->cancel();
    case Page::plan:
      return plan_->cancel();
    case Page::compare:
      compare_->cancel();
      return false;
    case Page::validate:
      validate_->cancel();
      return false;
    case Page::studies:
      return studies_->cancel();
    default:
      return false;
  }
}

void PageStack::openStudy(const std::filesystem::path& file)
{
  Q_EMIT pageAsked(Page::studies);
  studies_->open(file);
}

void PageStack::showSessionsError(const QString& sentence) { sessions_->say(sentence, true); }

}  // namespace perilymph::gui
