// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/PageLinks.h"

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/insert/InsertPage.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/outcome/OutcomePage.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/pages/plan/PlanView.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/pages/start/StartPage.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/Navigation.h"
#include "gui/shell/OverlayStack.h"
#include "gui/widgets/Notice.h"

namespace perilymph::gui {

namespace {

void linkPage(const Page& page, MainWindow& window)
{
  QObject::connect(&page, &Page::insertionRequested, &window, &MainWindow::load);
  QObject::connect(&page, &Page::replayRequested, &window, &MainWindow::replay);
  QObject::connect(&page, &Page::pageRequested, &window, &MainWindow::openOnPage);
  QObject::connect(&page, &Page::noted, &window.notice(), &Notice::showMessage);
}

}  // namespace

void linkPages(MainWindow& window)
{
  const PageStack& pages = window.pages();
  InsertionController& insertion = window.insertion();
  for (const Page* page : pages.all()) linkPage(*page, window);
  auto* insert = pages.find<InsertPage>();
  auto* start = pages.find<StartPage>();
  auto* ct = pages.find<CtPage>();
  auto* plan = pages.find<PlanPage>();
  auto* compare = pages.find<ComparePage>();
  auto* sessions = pages.find<SessionsPage>();
  if (ct != nullptr)
    window.navigation().sendCtOf(
        [ct](const session::Scenario& shown) { return ct->placedCt(shown); });
  if (ct != nullptr) {
    QObject::connect(ct, &CtPage::serversRequested, &window.sheets(), &OverlayStack::showServers);
    QObject::connect(&window.sheets(), &OverlayStack::serversChanged, ct, &CtPage::showServers);
  }
  if (auto* outcome = pages.find<OutcomePage>()) {
    QObject::connect(outcome, &OutcomePage::serversRequested, &window.sheets(),
                     &OverlayStack::showServers);
    QObject::connect(&window.sheets(), &OverlayStack::serversChanged, outcome,
                     &OutcomePage::showServers);
    QObject::connect(outcome, &OutcomePage::endingRequested, &window,
                     [outcome, &window](const QString& action, const std::function<void()>& act) {
                       window.endWork(*outcome, action, act);
                     });
    if (plan != nullptr)
      outcome->setPlannedPatient([plan] {
        return plan->plan() ? std::optional(plan->plan()->request.patient) : std::nullopt;
      });
    QObject::connect(outcome, &OutcomePage::kept, &window, &MainWindow::takeQuestionBack);
    if (start != nullptr)
      QObject::connect(start, &StartPage::outcomeRequested, outcome, &OutcomePage::openSaved);
  }
  if (ct != nullptr) {
    const CtPlaces places = [ct](const std::string& seriesKey) { return ct->placeOf(seriesKey); };
    if (plan != nullptr) plan->setCtPlaces(places);
    if (insert != nullptr) insert->setCtPlaces(places);
    if (sessions != nullptr) sessions->setCtPlaces(places);
  }
  if (ct != nullptr) {
    const BoneSource bone = [ct](const anatomy::Patient& patient) { return ct->boneOf(patient); };
    if (plan != nullptr) {
      plan->view().setBoneSource(bone);
      QObject::connect(&ct->bone(), &CtBone::changed, &plan->view(), &PlanView::refreshBone);
    }
    if (insert != nullptr) {
      insert->views().setBoneSource(bone);
      QObject::connect(&ct->bone(), &CtBone::changed, &insert->views(),
                       &InsertionViews::refreshBone);
    }
  }
  if (ct != nullptr) {
    ct->setInsertionSetup(
        {[&insertion]() -> const session::Scenario& { return insertion.history().now().scenario; },
         [&insertion] { return insertion.maySetUp(); },
         [&insertion](const SetupChange& change) { insertion.change(change); }});
    QObject::connect(&insertion, &InsertionController::setupChanged, ct, &CtPage::followSetup);
  }
  if (ct != nullptr && plan != nullptr) {
    QObject::connect(ct, &CtPage::planRequested, plan, &PlanPage::planFor);
    plan->setApproachSource(
        [ct](const anatomy::Patient& patient) { return ct->approachOf(patient); });
    QObject::connect(ct, &CtPage::approachChanged, plan, &PlanPage::showApproach);
  }
  if (ct != nullptr && start != nullptr)
    QObject::connect(start, &StartPage::ctRequested, ct,
                     qOverload<const CtRequest&>(&CtPage::begin));
  if (insert != nullptr && start != nullptr) {
    QObject::connect(insert, &InsertPage::allPatientsRequested, start, &StartPage::showPatients);
    QObject::connect(insert, &InsertPage::newPatientRequested, start, &StartPage::showNewPatient);
  }
  if (insert != nullptr && compare != nullptr)
    QObject::connect(insert, &InsertPage::compareRequested, compare, &ComparePage::compare);
  if (sessions == nullptr) return;
  if (insert != nullptr)
    QObject::connect(insert, &InsertPage::stateShown, sessions, &SessionsPage::follow);
  if (compare != nullptr)
    QObject::connect(sessions, &SessionsPage::compareRequested, compare, &ComparePage::compare);
  QObject::connect(sessions, &SessionsPage::referenceRead, &insertion,
                   &InsertionController::setReference);
  // on the page of the click
  QObject::connect(&insertion, &InsertionController::replayFailed, sessions,
                   [sessions, &window](const QString& sentence) {
                     if (sessions->isVisible()) return sessions->showError(sentence);
                     window.notice().showMessage(sentence);
                   });
}

}  // namespace perilymph::gui
