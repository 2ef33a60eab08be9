#include "MainWindow.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cstring>

#include "BottomBar.h"
#include "ChartColumn.h"
#include "KeyList.h"
#include "Numbers.h"
#include "OperationView.h"
#include "SidePanel.h"
#include "Theme.h"
#include "TopBar.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

constexpr int frameInterval_ms = 16;   // 60 Hz cap
constexpr int slowInterval_ms = 66;    // charts and numbers: 15 Hz
constexpr double longestStep_s = 0.1;  // after a stall, keys do not catch up

QFrame* line(QWidget* parent)
{
  auto* made = new QFrame(parent);
  made->setObjectName(QStringLiteral("line"));
  return made;
}

QString patientText(const session::Scenario& scenario)
{
  const bool isLeft = scenario.patient.side == anatomy::Side::left;
  const bool isPatient = scenario.anatomy == "published" || scenario.patient.basalTurn;
  return (isPatient ? MainWindow::tr("Patient %1 · %2 ear") : MainWindow::tr("%1 anatomy · %2 ear"))
      .arg(QString::fromStdString(isPatient ? scenario.patient.label : scenario.anatomy),
           isLeft ? MainWindow::tr("left") : MainWindow::tr("right"));
}

}  // namespace

MainWindow::MainWindow(session::Scenario scenario, std::optional<std::filesystem::path> record)
    : control_(std::move(scenario), std::move(record)),
      top_(new TopBar(this)),
      side_(new SidePanel(control_.scenario(), this)),
      view_(new OperationView(this)),
      charts_(new ChartColumn(this)),
      bottom_(new BottomBar(this)),
      keys_(new KeyList(view_))
{
  setObjectName(QStringLiteral("mainWindow"));
  setWindowTitle(tr("Perilymph · %1").arg(QString::fromStdString(control_.scenario().name)));
  setFont(typeface(13));
  setStyleSheet(windowStyle());
  setMinimumSize(1260, 720);
  resize(1280, 800);
  setFocusPolicy(Qt::StrongFocus);
  layOut();
  connectZones();
  top_->setPatient(patientText(control_.scenario()));
  top_->setDevice(Light::off, tr("preparing"), {});
  bottom_->setMain(BottomBar::Main::start, false);

  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(frameInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &MainWindow::onFrame);
}

MainWindow::~MainWindow() = default;

void MainWindow::layOut()
{
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  QFrame* leftLine = line(this);
  QFrame* rightLine = line(this);
  leftLine->setFixedWidth(1);
  rightLine->setFixedWidth(1);
  middle->addWidget(side_);
  middle->addWidget(leftLine);
  middle->addWidget(view_, 1);
  middle->addWidget(rightLine);
  middle->addWidget(charts_);

  QFrame* topLine = line(this);
  QFrame* bottomLine = line(this);
  topLine->setFixedHeight(1);
  bottomLine->setFixedHeight(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(top_);
  column->addWidget(topLine);
  column->addLayout(middle, 1);
  column->addWidget(bottomLine);
  column->addWidget(bottom_);
}

void MainWindow::connectZones()
{
  connect(top_, &TopBar::keysAsked, this, &MainWindow::toggleKeyList);
  connect(side_, &SidePanel::handChosen, this, &MainWindow::chooseHand);
  connect(side_, &SidePanel::holdChanged, this, &MainWindow::hold);
  connect(side_, &SidePanel::styletAsked, this, [this] { control_.pullStylet(); });
  connect(side_, &SidePanel::partShown, view_, &OperationView::setPartVisible);
  connect(side_, &SidePanel::experimentShown, charts_, &ChartColumn::setExperimentVisible);
  connect(bottom_, &BottomBar::startAsked, this, &MainWindow::start);
  connect(bottom_, &BottomBar::pauseAsked, this, &MainWindow::pause);
  connect(bottom_, &BottomBar::withdrawAsked, this, &MainWindow::withdraw);
  connect(bottom_, &BottomBar::resetAsked, this, &MainWindow::reset);
  connect(view_, &QOpenGLWidget::frameSwapped, this, &MainWindow::onPresented);
}

Result<Done> MainWindow::open()
{
  const Result<Done> prepared = control_.prepare(Hand::scripted);
  if (!prepared) return prepared;

  const session::Scenario& scenario = control_.scenario();
  view_->setScene(std::make_unique<visualization::InsertionScene>(
      control_.anatomy(), scenario.array, scenario.patient.side));
  charts_->setExperiment(charts::publishedExperiment());
  charts_->begin(control_.anatomy().entry());
  view_->showArray(control_.now());
  drawn_ = control_.now();
  showSlowly();
  sinceFrame_.start();
  sinceSlow_.start();
  timer_.start();
  return Done{};
}

void MainWindow::start()
{
  const Result<Done> begun = control_.begin();
  if (!begun) showTrouble(QString::fromStdString(begun.error().message));
  showState();
}

void MainWindow::pause()
{
  pressed_.clear();
  control_.pause();
  side_->setHeld(false);
  showState();
}

void MainWindow::withdraw()
{
  control_.withdraw();
  showState();
}

void MainWindow::reset() { prepare(control_.hand()); }

void MainWindow::chooseHand(Hand hand)
{
  if (hand != control_.hand()) prepare(hand);
}

void MainWindow::prepare(Hand hand)
{
  trouble_.clear();
  pressed_.clear();
  const Result<Done> prepared = control_.prepare(hand);
  if (!prepared) return showTrouble(QString::fromStdString(prepared.error().message));
  side_->setHand(control_.hand());
  side_->setHeld(false);
  charts_->begin(control_.anatomy().entry());
  view_->showArray(control_.now());
  drawn_ = control_.now();
  showSlowly();
}

void MainWindow::hold(bool isHeld)
{
  if (control_.hand() != Hand::pointer) return;
  control_.hold(isHeld);
  side_->setHeld(control_.isHeld());
}

void MainWindow::showTrouble(const QString& sentence)
{
  trouble_ = sentence;
  view_->setBanner(troubleWords());
}

bool MainWindow::isNewToTheEye(const haptics::Snapshot& now)
{
  const std::size_t nodes = now.nodes;
  const bool isSame =
      nodes == drawn_.nodes && now.output.styletWithdrawal == drawn_.output.styletWithdrawal &&
      std::memcmp(now.node_W.data(), drawn_.node_W.data(), nodes * sizeof now.node_W[0]) == 0 &&
      std::memcmp(now.normalForce.data(), drawn_.normalForce.data(),
                  nodes * sizeof now.normalForce[0]) == 0;
  if (!isSame) drawn_ = now;
  return !isSame;
}

void MainWindow::onFrame()
{
  meter_.begin(FrameMeter::Clock::now());
  const double elapsed_s = std::min(double(sinceFrame_.restart()) / 1e3, longestStep_s);

  const int direction = int(pressed_.count(Qt::Key_Down)) - int(pressed_.count(Qt::Key_Up));
  if (direction != 0)
    control_.advanceBy(Length::fromSi(direction * control_.scenario().speed.si() * elapsed_s));

  if (control_.update()) {
    const haptics::Snapshot& now = control_.now();
    if (isNewToTheEye(now)) view_->showArray(now);
    if (now.output.workflow != Workflow::idle && now.output.workflow != Workflow::armed)
      charts_->append(now.output);
  }
  view_->stepCamera(elapsed_s);

  bool isDrawn = view_->renderIfDirty();
  if (sinceSlow_.elapsed() >= slowInterval_ms) {
    sinceSlow_.restart();
    showSlowly();
    if (charts_->renderIfDirty()) isDrawn = true;
  }
  if (!isDrawn) meter_.cancel();
}

void MainWindow::onPresented()
{
  meter_.present(FrameMeter::Clock::now());
  if (!isFirstFrame_ || !timer_.isActive() || meter_.frames() == 0) return;
  isFirstFrame_ = false;
  Q_EMIT firstFrameShown();
}

void MainWindow::showSlowly()
{
  const haptics::TickOutput& now = control_.now().output;
  view_->showNumbers(now, control_.scenario().stopTravel);
  bottom_->setProgress(now.travel / control_.scenario().stopTravel.si(), now.time);
  showState();
}

void MainWindow::showState()
{
  const haptics::Snapshot& now = control_.now();
  const Workflow workflow = now.output.workflow;
  const bool isRunning = control_.isRunning();
  const bool isScripted = control_.hand() == Hand::scripted;
  const bool hasMoved = isRunning && workflow != Workflow::idle && workflow != Workflow::armed;
  const bool isThere = workflow == Workflow::finished || workflow == Workflow::fault;

  if (isScripted)
    bottom_->setMain(control_.isMoving() ? BottomBar::Main::pause : BottomBar::Main::start,
                     !isThere);
  else
    bottom_->setMain(BottomBar::Main::start, !isRunning);
  bottom_->setWithdrawEnabled(hasMoved && workflow != Workflow::fault && now.output.travel > 0.0 &&
                              (isScripted || workflow == Workflow::finished));
  side_->setHandChangeable(!hasMoved || isThere);
  side_->setHoldEnabled(isRunning && workflow != Workflow::fault);

  const bool hasStylet = control_.scenario().array.hasStylet;
  const double withdrawn_mm = inMillimeters(Length::fromSi(now.output.styletWithdrawal));
  const QString stylet = !hasStylet ? tr("no stylet")
                         : withdrawn_mm > 0.0
                             ? tr("stylet %1 mm out").arg(numberText(withdrawn_mm, 1))
                             : tr("Standard, stylet in");
  side_->setStylet(stylet, hasStylet && hasMoved && !control_.isStyletPulled());

  if (!isRunning)
    top_->setDevice(Light::off, tr("ready"), QString::fromStdString(control_.handName()));
  else if (workflow == Workflow::fault)
    top_->setDevice(Light::alarm, tr("fault · no force"), troubleWords());
  else if (now.measuredRate > 0.0)
    top_->setDevice(Light::steady,
                    tr("%1 Hz · %2 late").arg(numberText(now.measuredRate, 0)).arg(now.lateTicks),
                    tr("%1. Ticks a second as measured, and ticks that began more than one period "
                       "late.")
                        .arg(QString::fromStdString(control_.handName())));
  else
    top_->setDevice(Light::steady, tr("running"), QString::fromStdString(control_.handName()));

  bottom_->setStatus(statusWords(), !control_.recordingTrouble().empty());
  view_->setBanner(troubleWords());
  view_->setHint(hintWords());
}

QString MainWindow::statusWords() const
{
  const haptics::Snapshot& now = control_.now();
  QStringList words;
  if (!control_.recordingTrouble().empty())
    words << tr("NOT recording");
  else if (control_.isRunning())
    words << (now.lostRecords > 0 ? tr("recording, %1 ticks lost").arg(now.lostRecords)
                                  : tr("recording"));
  else
    words << tr("not started");
  if (control_.isRunning()) words << tr("late ticks: %1").arg(now.lateTicks);
  words << tr("%1 fps").arg(meter_.framesPerSecond(FrameMeter::Clock::now()));
  words << tr("not a medical device");
  return words.join(QStringLiteral(" · "));
}

QString MainWindow::troubleWords() const
{
  const haptics::TickOutput& now = control_.now().output;
  if (now.workflow == Workflow::fault) {
    const QString what = (now.status & haptics::deviceLost) != 0 ? tr("The hand stopped answering.")
                         : (now.status & haptics::notFinite) != 0
                             ? tr("The computed motion left every bound.")
                             : tr("The insertion was stopped.");
    return what + tr(" The force is off and the array rests. Press Reset to begin anew.");
  }
  if (!trouble_.isEmpty()) return trouble_;
  const std::string recording = control_.recordingTrouble();
  if (!recording.empty())
    return tr("This insertion is not being recorded: %1").arg(QString::fromStdString(recording));
  return {};
}

QString MainWindow::hintWords() const
{
  const haptics::TickOutput& now = control_.now().output;
  if (control_.isAtDepth()) return tr("Full depth. Withdraw or Reset.");
  if (now.workflow == Workflow::finished) return tr("The array is out. Reset to insert again.");
  if (control_.hand() == Hand::scripted) return {};
  if (!control_.isRunning()) return tr("Press Start, then hold Space and turn the wheel.");
  if (!control_.isHeld()) return tr("Hold Space, then turn the wheel or press Down.");
  return tr("Array held. Wheel or Down advances, Up withdraws.");
}

}  // namespace perilymph::gui
