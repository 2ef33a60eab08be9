// Changes of the setup: from the panel to the cochlea, the array and the picture, and back again.

#include "InsertionViews.h"
#include "MainWindow.h"
#include "OperationView.h"
#include "Replay.h"
#include "SetupHistory.h"
#include "SidePanel.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

std::string valueOf(const session::Scenario& scenario, const std::string& wanted)
{
  for (const auto& [key, value] : scenario.values)
    if (key == wanted) return value;
  return {};
}

/// True if both are built from the same numbers.
bool haveSameCochlea(const session::Scenario& one, const session::Scenario& other)
{
  for (const char* key : {"anatomy", "lead_in_mm", "patient_numbers.st_length_mm",
                          "patient_numbers.rw_width_mm", "patient_numbers.rw_height_mm",
                          "patient_numbers.a_mm", "patient_numbers.b_mm", "patient_numbers.h_mm"})
    if (valueOf(one, key) != valueOf(other, key)) return false;
  return true;
}

/// True if they look alike before anything moves.
bool lookAlike(const session::Scenario& one, const session::Scenario& other)
{
  return haveSameCochlea(one, other) && one.arrayName == other.arrayName &&
         one.arrayFingerprint == other.arrayFingerprint && one.patient.side == other.patient.side;
}

}  // namespace

void MainWindow::connectSetup()
{
  connect(setup_, &SetupHistory::setupChanged, this, &MainWindow::useSetup);
  connect(setup_, &SetupHistory::refused, this, &MainWindow::showTrouble);
  connect(side_, &SidePanel::changeAsked, this, [this](const Change& change) {
    if (isChangeable()) setup_->change(change);
  });
  connect(side_, &SidePanel::restoreAsked, this, [this] {
    if (isChangeable()) setup_->restore();
  });
  connect(side_, &SidePanel::undoAsked, this, &MainWindow::undo);
  connect(side_, &SidePanel::redoAsked, this, &MainWindow::redo);
}

void MainWindow::resume(const Origin& origin, const Setup& now)
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
    anatomyWork_.forget();
    return showScenario();
  }
  if (control_.hasAnatomy() && haveSameCochlea(wanted, held)) {
    anatomyWork_.forget();
    return use(wanted, nullptr);
  }
  anatomyWork_.build(
      wanted, [this, wanted](const Result<std::shared_ptr<const anatomy::ScalaTympani>>& built) {
        if (built) return use(wanted, *built);
        isStartAsked_ = false;
        setup_->undo();  // the panel goes on telling the truth
        showTrouble(QString::fromStdString(built.error().message));
      });
  showState();
}

void MainWindow::use(const session::Scenario& scenario,
                     std::shared_ptr<const anatomy::ScalaTympani> anatomy)
{
  const bool isSameToTheEye = lookAlike(scenario, control_.scenario());
  if (!isSameToTheEye) views_->forgetScene();
  control_.use(scenario, std::move(anatomy));
  showScenario();
  prepare(control_.hand());
  if (!isSameToTheEye) showCochlea();
  if (isStartAsked_) start();
}

}  // namespace perilymph::gui
