// Changes of the setup: from the panel to the cochlea, the array and the picture, and back again.

#include "gui/pages/insert/BuildingNote.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/run/ScenarioDifference.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/SetupHistory.h"
#include "gui/shell/MainWindow.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

}  // namespace

void MainWindow::connectSetup()
{
  connect(setup_, &SetupHistory::setupChanged, this, &MainWindow::useSetup);
  connect(setup_, &SetupHistory::refused, this, &MainWindow::showError);
  connect(side_, &SidePanel::changeAsked, this, [this](const SetupChange& change) {
    if (isChangeable()) setup_->change(change);
  });
  connect(side_, &SidePanel::restoreAsked, this, [this] {
    if (isChangeable()) setup_->restore();
  });
  connect(side_, &SidePanel::undoAsked, this, &MainWindow::undo);
  connect(side_, &SidePanel::redoAsked, this, &MainWindow::redo);
  connect(building_, &BuildingNote::cancelAsked, this, &MainWindow::cancelBuilding);
}

void MainWindow::resume(const SetupOrigin& origin, const Setup& now)
{
  setup_->resume(origin, now);
  showScenario();
}

bool MainWindow::isChangeable() const
{
  const Workflow workflow = control_.now().output.workflow;
  const bool isThere = workflow == Workflow::finished || workflow == Workflow::fault;
  const bool hasMoved =
      control_.isRunning() && workflow != Workflow::idle && workflow != Workflow::armed;
  return (!hasMoved || isThere) && !control_.isMoving() && !isStartAsked_ && !replay_->isOpen();
}

void MainWindow::undo()
{
  if (isChangeable() && setup_->stack().canUndo()) setup_->undo();
}

void MainWindow::redo()
{
  if (isChangeable() && setup_->stack().canRedo()) setup_->redo();
}

void MainWindow::useSetup()
{
  side_->showSetup(*setup_);
  const session::Scenario& wanted = setup_->now().scenario;
  const session::Scenario& held = control_.scenario();
  if (wanted.text == held.text) {
    modelBuilder_.forget();
    return showScenario();
  }
  if (haveSameModel(wanted, held)) {
    modelBuilder_.forget();
    return use(wanted, std::nullopt);
  }
  build(wanted, [this, wanted](const InsertionControl::Parts& parts) { use(wanted, parts); });
}

void MainWindow::build(const session::Scenario& scenario,
                       std::function<void(const InsertionControl::Parts&)> use)
{
  const bool isSameCochlea = haveSameCochlea(scenario, control_.scenario());
  modelBuilder_.build(scenario, isSameCochlea ? control_.sharedAnatomy() : nullptr,
                      [this, use = std::move(use)](const Result<InsertionControl::Parts>& built) {
                        if (built) return use(*built);
                        cancelBuilding();
                        showError(QString::fromStdString(built.error().message));
                      });
  showScenario();
  showState();
}

void MainWindow::cancelBuilding()
{
  modelBuilder_.forget();
  isStartAsked_ = false;
  setup_->goTo(control_.scenario().text);  // the panel goes on telling the truth
  showState();
}

void MainWindow::use(const session::Scenario& scenario,
                     const std::optional<InsertionControl::Parts>& parts)
{
  const bool isSameToTheEye = lookAlike(scenario, control_.scenario());
  if (!isSameToTheEye) views_->forgetScene();
  control_.use(scenario, parts);
  showScenario();
  prepare(control_.hand());
  if (!isSameToTheEye) showCochlea();
  if (isStartAsked_) start();
}

}  // namespace perilymph::gui
