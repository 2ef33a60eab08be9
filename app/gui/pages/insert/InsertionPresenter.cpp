// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertionPresenter.h"

#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/insert/BuildingNote.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/FrameMeter.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/InsertionText.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/run/SnapshotDifference.h"
#include "gui/run/WorkflowPredicates.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/StopTravel.h"
#include "gui/text/DeviceRate.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/PublishedConditions.h"

namespace perilymph::gui {

InsertionPresenter::InsertionPresenter(InsertionController& insertion, Zones zones)
    : insertion_(insertion),
      control_(insertion.control()),
      zones_(zones),
      ghost_(*zones.views->operation())
{
}

void InsertionPresenter::showCochlea()
{
  zones_.views->setScene(control_.anatomy(), control_.scenario());
  zones_.side->announceParts();
  zones_.views->operation()->showArray(control_.now());
  const session::Scenario& scenario = control_.scenario();
  ghost_.setCurrent(session::subjectOf(scenario.text(), scenario.name()));
}

void InsertionPresenter::showReference()
{
  const std::optional<ReferenceInsertion>& reference = insertion_.reference();
  zones_.views->charts()->setGhost(reference);
  zones_.side->setReference(reference);
  ghost_.setReference(reference);
}

void InsertionPresenter::showPlan()
{
  zones_.views->charts()->setPlan(insertion_.plan());
  zones_.views->charts()->showPlanIn(control_.scenario());
}

void InsertionPresenter::showPrepared()
{
  showInput();
  zones_.side->setHeld(false);
  const session::Scenario& scenario = control_.scenario();
  const bool isComparable = analysis::hasPublishedConditions(scenario);
  zones_.side->setComparable(isComparable);
  zones_.views->charts()->setComparable(isComparable);
  zones_.views->charts()->showPlanIn(scenario);
  zones_.views->charts()->showRibsOf(scenario);
  zones_.views->charts()->begin(control_.anatomy().entry());
  zones_.views->operation()->setPartial(outsideAtStop(scenario).si() > 0.0);
  zones_.views->operation()->showArray(control_.now());
  drawn_ = control_.now();
}

void InsertionPresenter::showInput()
{
  zones_.side->setInput(control_.input(), QString::fromStdString(control_.inputName()));
}

bool InsertionPresenter::isNew(const haptics::Snapshot& now)
{
  if (lookAlike(now, drawn_)) return false;
  drawn_ = now;
  return true;
}

void InsertionPresenter::step()
{
  if (!control_.update()) return;
  const haptics::Snapshot& now = control_.now();
  const bool isMoved = isNew(now);
  if (isMoved) zones_.views->operation()->showArray(now);
  ghost_.follow(now.output.depth);
  // at rest the charts stand still, too
  const bool isResting = (now.output.status & haptics::resting) != 0;
  const bool isMoving = isMoved || now.output.workflow == haptics::Workflow::inserting;
  if (isMoving && !isResting && hasBegun(now.output.workflow))
    zones_.views->charts()->append(now.output, now.peak);
}

void InsertionPresenter::updateReadouts(const FrameMeter& meter)
{
  const haptics::TickOutput& now = control_.now().output;
  const Length stopTravel = control_.scenario().stopTravel();
  zones_.views->operation()->showNumbers(
      now,
      analysis::angularInsertionDepth(control_.anatomy(), control_.scenario().array(),
                                      control_.now()),
      stopTravel);
  zones_.views->showSlowly(control_.now());
  zones_.views->weigh(meter);
  zones_.bottom->setProgress(now.travel / stopTravel.si(), now.time);
}

void InsertionPresenter::showState(const FrameMeter& meter)
{
  const SetupControl& setup = insertion_.setup();
  const InsertionState state = stateOf(control_);
  zones_.building->show(setup.buildingFor_ms());
  showButtons(state);
  zones_.side->setChangeable(insertion_.maySetUp());
  zones_.side->setHoldEnabled(mayHold(state));
  zones_.side->setStylet(styletText(control_), mayPullStylet(state));
  zones_.side->setTiming(timingText(control_, meter.framesPerSecond(FrameMeter::Clock::now())));
  zones_.bottom->setStatus(statusText(control_, deviceRateText(control_.deviceHealth())),
                           !control_.recordingError().empty());
  showBanner();
  zones_.views->operation()->setHint(setup.isBuilding() ? buildingHint(setup.isStartRequested())
                                                        : hintText(control_));
}

void InsertionPresenter::showButtons(const InsertionState& state)
{
  const bool isBusy = insertion_.setup().isBuilding();
  zones_.bottom->setMain(mayPause(state) ? BottomBar::Main::pause : BottomBar::Main::start,
                         mayStart(state) && !isBusy);
  zones_.bottom->setWait(
      isBusy ? BottomBar::tr("The cochlea is being built; the insertion can start afterwards.")
             : QString());
  zones_.bottom->setWithdrawEnabled(mayWithdraw(state));
}

void InsertionPresenter::showBanner() { zones_.views->operation()->setBanner(insertion_.error()); }

}  // namespace perilymph::gui
