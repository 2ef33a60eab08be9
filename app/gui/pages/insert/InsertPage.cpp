// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertPage.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/insert/BuildingNote.h"
#include "gui/pages/insert/FrameLoop.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayControl.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/parts/DataText.h"
#include "gui/parts/Theme.h"
#include "gui/run/ScenarioDifference.h"
#include "gui/run/WorkflowPredicates.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/PatientSetup.h"

namespace perilymph::gui {

namespace {

constexpr double magnify = 1.1;  // per notch of the wheel

QFrame* line(QWidget* parent)
{
  auto* made = new QFrame(parent);
  made->setObjectName(QStringLiteral("line"));
  return made;
}

}  // namespace

InsertPage::InsertPage(session::Scenario scenario, std::optional<std::filesystem::path> record,
                       std::shared_ptr<CochleaStore> cochleae, QWidget* parent)
    : QWidget(parent),
      control_(std::move(scenario), std::move(record), std::move(cochleae)),
      safety_(control_),
      setup_(new SetupControl(control_, this)),
      side_(new SidePanel(control_.cochleae(), this)),
      views_(new InsertionViews(this)),
      bottom_(new BottomBar(this)),
      building_(new BuildingNote(views_->operation())),
      replay_(new ReplayControl(*views_, this)),
      bars_(new QStackedWidget(this)),
      frames_(new FrameLoop(
          {[this](double elapsed_s) { step(elapsed_s); }, [this] { stepSlowly(); },
           [this] { return view().renderIfDirty(); },
           [this] { return views_->charts()->renderIfDirty(); }, [this] { return isShown(); }},
          this)),
      presenter_(control_, *setup_, {side_, views_, bottom_, building_}),
      held_(control_, *side_)
{
  layOut();
  connectParts();
  connectSetup();
  setup_->history().begin({control_.scenario(), {}}, SetupOrigin::Kind::preset);
  bottom_->setMain(BottomBar::Main::start, false);
}

InsertPage::~InsertPage() = default;

OperationView& InsertPage::view() { return *views_->operation(); }

void InsertPage::layOut()
{
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  QFrame* leftLine = line(this);
  leftLine->setFixedWidth(1);
  middle->addWidget(side_);
  middle->addWidget(leftLine);
  middle->addWidget(views_, 1);

  QFrame* bottomLine = line(this);
  bottomLine->setFixedHeight(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(middle, 1);
  column->addWidget(bottomLine);
  bars_->addWidget(bottom_);
  bars_->addWidget(replay_->bar());
  bars_->setFixedHeight(shownLengths().bar);
  column->addWidget(bars_);
}

void InsertPage::connectParts()
{
  connect(side_, &SidePanel::handChosen, this, &InsertPage::chooseInput);
  connect(side_, &SidePanel::devicesAsked, this, &InsertPage::devicesAsked);
  connect(side_, &SidePanel::holdChanged, this, [this](bool isHeld) { held_.hold(isHeld); });
  connect(side_, &SidePanel::styletAsked, this, &InsertPage::pullStylet);
  connect(side_, &SidePanel::partShown, &view(), &OperationView::setPartVisible);
  connect(side_, &SidePanel::removeReferenceAsked, this, [this] { setReference(std::nullopt); });
  connect(side_, &SidePanel::experimentShown, views_->charts(), &ForceCharts::setExperimentVisible);
  connect(bottom_, &BottomBar::startAsked, this, &InsertPage::start);
  connect(bottom_, &BottomBar::pauseAsked, this, &InsertPage::pause);
  connect(bottom_, &BottomBar::withdrawAsked, this, &InsertPage::withdraw);
  connect(bottom_, &BottomBar::resetAsked, this, &InsertPage::reset);
  connect(replay_, &ReplayControl::opened, this, &InsertPage::beginReplay);
  connect(replay_, &ReplayControl::failed, this, &InsertPage::replayFailed);
  connect(replay_, &ReplayControl::closeAsked, this, &InsertPage::closeReplay);
  connect(&view(), &QOpenGLWidget::frameSwapped, frames_, &FrameLoop::present);
  const auto pace = [this] {
    frames_->setInterval(visualization::traitsOf(views_->quality()).frameInterval_ms);
  };
  connect(views_, &InsertionViews::qualityChanged, frames_, pace);
  pace();
}

void InsertPage::connectSetup()
{
  SetupHistory* history = &setup_->history();
  connect(history, &SetupHistory::setupChanged, this, [this, history] {
    side_->showSetup(*history);
    setup_->follow();
  });
  connect(history, &SetupHistory::refused, this, &InsertPage::showError);
  connect(setup_, &SetupControl::ready, this, &InsertPage::use);
  connect(setup_, &SetupControl::failed, this, &InsertPage::showError);
  connect(setup_, &SetupControl::followed, this, [this] {
    showState();
    Q_EMIT subjectChanged();
  });
  connect(side_, &SidePanel::changeAsked, this, [this, history](const SetupChange& change) {
    if (maySetUpNow()) Q_EMIT noted(setup_->change(change));
  });
  connect(side_, &SidePanel::restoreAsked, this, [this, history] {
    if (maySetUpNow()) history->restore();
  });
  connect(side_, &SidePanel::patientChosen, this, &InsertPage::openPatient);
  connect(side_, &SidePanel::allPatientsAsked, this, &InsertPage::allPatientsAsked);
  connect(side_, &SidePanel::newPatientAsked, this, &InsertPage::newPatientAsked);
  connect(side_, &SidePanel::undoAsked, this, &InsertPage::undo);
  connect(side_, &SidePanel::redoAsked, this, &InsertPage::redo);
  connect(building_, &BuildingNote::cancelAsked, setup_, &SetupControl::cancel);
}

Result<Done> InsertPage::open()
{
  control_.use(control_.scenario(), setup_->takeFirst());
  const Result<Done> prepared = control_.prepare(InputSource::scripted);
  if (!prepared) return prepared;
  views_->charts()->setExperiment(charts::publishedExperiment());
  presenter_.showCochlea();
  showPrepared();
  if (inputBefore_ != InputSource::scripted) prepare(inputBefore_);
  frames_->start();
  return Done{};
}

InsertPage::Memory InsertPage::memory() const
{
  return {setup().memory(), views_->charts()->ghost(),
          replay_->isOpen() ? inputBefore_ : control_.hand(), control_.chosen(),
          views_->charts()->plan()};
}

void InsertPage::resume(const Memory& memory)
{
  setup_->history().resume(memory.setup);
  setReference(memory.ghost);
  setPlan(memory.plan);
  control_.choose(memory.device);
  inputBefore_ = memory.input;
  Q_EMIT subjectChanged();
}

void InsertPage::load(const Setup& setup, SetupOrigin::Kind kind, AfterLoading then)
{
  pause();
  closeReplay();
  setup_->build(setup.scenario, [this, setup, kind, then](const InsertionControl::Parts& parts) {
    views_->forgetScene();
    control_.use(setup.scenario, parts);
    setup_->history().begin(setup, kind);
    Q_EMIT subjectChanged();
    prepare(InputSource::scripted);
    presenter_.showCochlea();
    if (then == AfterLoading::insert) start();
  });
}

void InsertPage::openPatient(const anatomy::Patient& patient)
{
  if (!maySetUpNow()) return;
  const auto setup = setupOfPatient(patient, &setup_->history().now().scenario);
  if (!setup) return showError(dataText(setup.error().message));
  load(*setup, SetupOrigin::Kind::own, AfterLoading::rest);
}

void InsertPage::use(const session::Scenario& scenario,
                     const std::optional<InsertionControl::Parts>& parts)
{
  const bool looksTheSame = lookAlike(scenario, control_.scenario());
  if (!looksTheSame) views_->forgetScene();
  control_.use(scenario, parts);
  Q_EMIT subjectChanged();
  prepare(control_.hand());
  if (!looksTheSame) presenter_.showCochlea();
  if (setup_->isStartAsked()) start();
}

bool InsertPage::maySetUpNow() const
{
  return maySetUp(stateOf(control_)) && !setup_->isStartAsked() && !replay_->isOpen();
}

void InsertPage::undo()
{
  if (maySetUpNow() && setup().stack().canUndo()) setup_->history().undo();
}

void InsertPage::redo()
{
  if (maySetUpNow() && setup().stack().canRedo()) setup_->history().redo();
}

bool InsertPage::cancelBuilding()
{
  if (!setup_->isBuilding()) return false;
  setup_->cancel();
  return true;
}

void InsertPage::start()
{
  // Edited values are committed, and the result is built first.
  const QString refused = maySetUpNow() ? side_->commit() : QString();
  if (!refused.isEmpty()) return showError(refused);
  setup_->history().seal();
  setup_->startWhenBuilt(setup_->isBuilding());
  if (setup_->isBuilding()) return showState();
  const Result<Done> begun = control_.begin();
  if (!begun) showError(dataText(begun.error().message));
  showState();
}

void InsertPage::pause()
{
  control_.pause();
  setup_->startWhenBuilt(false);
  held_.letGo();
  showState();
}

bool InsertPage::rest()
{
  if (!control_.isMoving() && !control_.isHeld() && !control_.isDeviceActive()) return false;
  pause();
  return true;
}

void InsertPage::withdraw()
{
  control_.withdraw();
  showState();
}

void InsertPage::reset() { prepare(control_.hand()); }

void InsertPage::useDevice(InsertionControl::DeviceFactory device)
{
  control_.choose(std::move(device));
  prepare(InputSource::device);
}

void InsertPage::prepare(InputSource input)
{
  presenter_.forgetError();
  held_.letGo();
  const Result<Done> prepared = control_.prepare(input);
  if (!prepared && input == InputSource::device) {
    // If a device cannot be opened, the script remains the input device.
    prepare(InputSource::scripted);
    return showError(dataText(prepared.error().message));
  }
  if (!prepared) return showError(dataText(prepared.error().message));
  showPrepared();
}

void InsertPage::openReplay(const std::filesystem::path& file) { replay_->open(file); }

void InsertPage::beginReplay()
{
  // Only the display may move: the insertion ends, and no device remains open.
  setup_->forget();
  inputBefore_ = control_.hand();
  prepare(InputSource::scripted);
  bars_->setCurrentWidget(replay_->bar());
  side_->hide();  // it belongs to the next insertion, not to this recording
  replay_->begin();
  Q_EMIT replayOpened();
  Q_EMIT subjectChanged();
}

void InsertPage::closeReplay()
{
  if (!replay_->isOpen()) return;
  replay_->close();
  bars_->setCurrentWidget(bottom_);
  side_->show();
  Q_EMIT subjectChanged();
  prepare(inputBefore_);
  presenter_.showCochlea();
  side_->showSetup(setup());
  setup_->follow();  // a change that was being built when the replay began
}

void InsertPage::setReference(const std::optional<ReferenceInsertion>& reference)
{
  presenter_.setReference(reference);
}

bool InsertPage::takeReplayKey(const QKeyEvent& event) { return replay_->takeKey(event); }

void InsertPage::pressSpace()
{
  if (control_.hand() == InputSource::pointer) {
    if (!control_.isRunning()) start();
    held_.hold(true);
  } else if (control_.isMoving() || control_.isDeviceActive()) {
    pause();
  } else {
    start();
  }
}

void InsertPage::turnWheel(double notches, bool isZoom)
{
  if (isZoom || !held_.turnWheel(notches)) view().zoom(std::pow(magnify, notches));
}

bool InsertPage::leavePanel()
{
  if (!isShown() || !side_->isAncestorOf(window()->focusWidget())) return false;
  window()->setFocus();
  return true;
}

void InsertPage::togglePanel() { side_->setCollapsed(!side_->isCollapsed()); }

bool InsertPage::stopDevice()
{
  if (!safety_.stopDevice()) return false;
  showState();
  return true;
}

void InsertPage::loseKeyboard()
{
  safety_.loseKeyboard();
  held_.letGo();
}

void InsertPage::leaveSight()
{
  if (safety_.leaveSight()) pause();
}

void InsertPage::step(double elapsed_s)
{
  held_.drive();
  if (replay_->isOpen())
    replay_->step(elapsed_s, isShown());
  else
    presenter_.step();
  view().stepCamera(elapsed_s);
}

void InsertPage::stepSlowly()
{
  if (replay_->isOpen()) return replay_->stepSlowly();
  presenter_.stepSlowly(frames_->meter());
  showState();
}

void InsertPage::showState()
{
  presenter_.showState(frames_->meter(), maySetUpNow());
  Q_EMIT stateShown();
}

void InsertPage::showPrepared()
{
  presenter_.showPrepared();
  stepSlowly();
  Q_EMIT recordingChanged();
}

}  // namespace perilymph::gui
