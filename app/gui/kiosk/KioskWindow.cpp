// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/KioskWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "gui/kiosk/LeaderboardView.h"
#include "gui/scene/OperationView.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/ContactPositions.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;
using visualization::CameraPreset;

constexpr int frameInterval_ms = 16;
constexpr int slowInterval_ms = 66;
constexpr double longestStep_s = 0.1;
constexpr double station_s = 6.0;  // duration of each camera view
constexpr double rest_s = 4.0;     // pause at full depth before the insertion repeats
constexpr Speed byKey = millimetersPerSecond(2);

/// Camera views of the demonstration, in order.
constexpr std::array tour{CameraPreset::surgeon, CameraPreset::overview, CameraPreset::followTip};

std::array<QString, tour.size()> tourSentences()
{
  return {KioskWindow::tr(
              "A cochlear implant restores hearing with electrodes in the inner ear. A surgeon "
              "inserts the electrode array by hand, through an opening of one to two millimeters."),
          KioskWindow::tr("The cochlea is coiled like a snail shell. The array must follow it "
                          "without damaging the delicate basilar membrane."),
          KioskWindow::tr("The forces are a few hundredths of a newton. Here they are computed a "
                          "thousand times per second, so that the insertion can be practiced.")};
}

}  // namespace

KioskWindow::KioskWindow(session::Scenario scenario, std::filesystem::path board, KioskClock clock,
                         std::shared_ptr<CochleaStore> cochleae)
    : control_(std::move(scenario), std::nullopt, std::move(cochleae)),
      clock_(std::move(clock)),
      board_(std::move(board)),
      peaks_(analysis::peaksInPatients()),
      screen_(new KioskScreen(this))
{
  control_.disableRecording();
  setObjectName(QStringLiteral("kioskWindow"));
  setWindowTitle(tr("Perilymph"));
  setFont(typeface(16));
  setStyleSheet(windowStyle());
  setMinimumSize(1024, 720);
  resize(1280, 800);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::PreventContextMenu);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(screen_);
  screen_->board().setSource(peakSource(peaks_));
  connect(screen_, &KioskScreen::startOverRequested, this, [this] { beginTurn(control_.input()); });
  connect(screen_, &KioskScreen::handleRequested, this, &KioskWindow::chooseHandle);
  connect(screen_, &KioskScreen::leaveRequested, this, &KioskWindow::beginAttract);
  connect(screen_, &KioskScreen::stopRequested, this, &KioskWindow::letGo);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(frameInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &KioskWindow::onFrame);
  connect(&screen_->view(), &QOpenGLWidget::frameSwapped, this, &KioskWindow::onPresented);
  qApp->installEventFilter(this);
}

KioskWindow::~KioskWindow() = default;

bool KioskWindow::eventFilter(QObject* target, QEvent* event)
{
  auto* widget = qobject_cast<QWidget*>(target);
  if (widget == nullptr || widget->window() != this) return QWidget::eventFilter(target, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
      touchedAt_s_ = now_s();
      if (stage_ != KioskStage::attract) {
        if (event->type() != QEvent::Wheel && !screen_->isStop(target)) continueTurn();
        return false;
      }
      if (event->type() != QEvent::Wheel) beginTurn(InputSource::pointer);
      return true;
    case QEvent::MouseMove:
      touchedAt_s_ = now_s();
      return false;
    case QEvent::KeyPress:
      return takeKey(static_cast<QKeyEvent*>(event));
    case QEvent::WindowDeactivate:
      letGo();
      return false;
    default:
      return false;
  }
}

bool KioskWindow::takeKey(QKeyEvent* event)
{
  touchedAt_s_ = now_s();
  const auto both = Qt::ControlModifier | Qt::AltModifier;
  if (event->key() == Qt::Key_Q && (event->modifiers() & both) == both) {
    letGo();
    Q_EMIT ended();
    return true;
  }
  if (event->isAutoRepeat()) return true;
  if (stage_ == KioskStage::attract) {
    beginTurn(InputSource::pointer);
  } else if (event->key() == Qt::Key_Escape) {
    beginAttract();
  } else if (stage_ == KioskStage::result) {
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return)
      beginTurn(control_.input());
  } else if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Down) {
    pushedByKey_ = 1;
  } else if (event->key() == Qt::Key_Up) {
    pushedByKey_ = -1;
  }
  return true;
}

void KioskWindow::keyReleaseEvent(QKeyEvent* event)
{
  if (!event->isAutoRepeat()) pushedByKey_ = 0;
}

void KioskWindow::closeEvent(QCloseEvent* event)
{
  // Alt+F4 is disabled for visitors
  event->ignore();
}

Result<void> KioskWindow::open()
{
  const Result<void> prepared = control_.prepare(InputSource::scripted);
  if (!prepared) return prepared;
  const session::Scenario& scenario = control_.scenario();
  screen_->view().setScene(std::make_unique<visualization::InsertionScene>(
      control_.anatomy(), scenario.array(), scenario.patient().side,
      visualization::Quality::software,
      sceneStyle(shownColorScheme(), KioskScreen::label_px / 12.0)));
  sinceFrame_.start();
  sinceSlow_.start();
  timer_.start();
  beginAttract();
  return {};
}

void KioskWindow::setStage(KioskStage stage)
{
  stage_ = stage;
  stageAt_s_ = now_s();
  touchedAt_s_ = now_s();
  screen_->showFooter(stage);
  setFocus();
}

void KioskWindow::showBoard(std::optional<int> chosen)
{
  const std::vector<KioskEntry>& entries = board_.entriesOf(clock_.today().date());
  QStringList text;
  for (const KioskEntry& entry : entries)
    text << peakText(millinewtons(entry.peak_mN).si(), peaks_);
  screen_->board().show(entries, text, chosen);
}

bool KioskWindow::prepare(InputSource input)
{
  letGo();
  turn_ = {};
  const Result<void> prepared = control_.prepare(input);
  const Result<void> begun = prepared ? control_.begin() : prepared;
  screen_->view().setBanner(begun ? QString() : dataText(begun.error().message));
  if (prepared) screen_->view().showArray(control_.now());
  return static_cast<bool>(begun);
}

void KioskWindow::beginAttract()
{
  restingAt_s_.reset();
  // if preparation fails, it is repeated after the pause
  if (!prepare(InputSource::scripted)) restingAt_s_ = now_s();
  const bool isAnew = stage_ != KioskStage::attract || station_ < 0;
  if (!isAnew) return;
  setStage(KioskStage::attract);
  station_ = -1;
  showBoard(std::nullopt);
}

void KioskWindow::stepAttract()
{
  const int station = int((now_s() - stageAt_s_) / station_s) % int(tour.size());
  if (station != station_) {
    station_ = station;
    screen_->view().glideTo(tour[std::size_t(station)]);
    screen_->showMessage(tr("Inserting a cochlear implant"), tourSentences()[std::size_t(station)]);
  }
  const Workflow workflow = control_.now().output.workflow;
  const bool isOver = control_.isAtDepth() || workflow == Workflow::fault || hasEndedEarly();
  if (isOver && !restingAt_s_) restingAt_s_ = now_s();
  if (restingAt_s_ && now_s() - *restingAt_s_ >= rest_s) beginAttract();
}

void KioskWindow::chooseHandle()
{
  if (control_.input() == InputSource::device) return beginTurn(InputSource::pointer);
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  const auto found = std::find_if(survey.devices.begin(), survey.devices.end(),
                                  [](const device::FoundDevice& each) { return each.isUsable(); });
  if (found == survey.devices.end()) return beginTurn(InputSource::pointer);
  control_.choose(*found);
  beginTurn(InputSource::device);
}

void KioskWindow::useDevice(InsertionControl::DeviceFactory device)
{
  control_.choose(std::move(device));
  beginTurn(InputSource::device);
}

void KioskWindow::beginTurn(InputSource input)
{
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  screen_->offerHandle(
      std::any_of(survey.devices.begin(), survey.devices.end(),
                  [](const device::FoundDevice& each) { return each.isUsable(); }));
  if (input == InputSource::scripted) input = InputSource::pointer;
  setStage(KioskStage::turn);
  if (!prepare(input)) {
    if (input == InputSource::device) return beginTurn(InputSource::pointer);
    screen_->showMessage(tr("Not available now"), tr("Please ask the booth staff."));
    return setStage(KioskStage::result);
  }
  const bool isHandle = input == InputSource::device;
  screen_->useHandle(isHandle);
  screen_->view().glideTo(CameraPreset::surgeon);
  inviteToTurn();
  showBoard(std::nullopt);
}

void KioskWindow::inviteToTurn()
{
  const bool isHandle = control_.input() == InputSource::device;
  screen_->showMessage(
      tr("Your turn"),
      isHandle
          ? tr("Hold the device button and advance gently. Keep the force low until full depth.")
          : tr("Hold the bar to insert; further right is faster. Keep the force low until full "
               "depth."));
}

bool KioskWindow::hasEndedEarly() const
{
  return control_.earlyEnd() != haptics::InsertionEnd::none;
}

void KioskWindow::endTurn()
{
  letGo();
  if (control_.now().output.workflow == Workflow::fault) {
    screen_->showMessage(
        tr("The insertion was stopped"),
        tr("The simulation became unstable and was stopped. The force is off. Try again."));
    return setStage(KioskStage::result);
  }
  if (hasEndedEarly()) {
    screen_->showMessage(
        tr("The array is stuck"),
        tr("It bent or jammed before full depth. The force is off. Try again, slower."));
    return setStage(KioskStage::result);
  }
  const QDateTime today = clock_.today();
  const KioskEntry entry{today.time(), inMillinewtons(Force::fromSi(turn_.peakForce())),
                         turn_.duration(), turn_.reversals()};
  const std::optional<int> place = board_.enter(today.date(), entry);
  const QString peak = numberText(entry.peak_mN, 0);
  const QString duration = numberText(entry.duration_s, 1),
                meaning = peakText(turn_.peakForce(), peaks_);
  screen_->showMessage(
      place ? tr("Full depth · peak force %1 mN · place %2 today").arg(peak).arg(*place)
            : tr("Full depth · peak force %1 mN").arg(peak),
      entry.reversals == 0
          ? tr("%1 s, no reversals. %2").arg(duration, meaning)
          : tr("%1 s, reversals: %3. %2").arg(duration, meaning, QString::number(entry.reversals)));
  setStage(KioskStage::result);
  showBoard(place);
  if (!board_.error().empty()) screen_->view().setBanner(QString::fromStdString(board_.error()));
}

void KioskWindow::letGo()
{
  pushedByKey_ = 0;
  control_.pause();
  screen_->release();
  if (stage_ == KioskStage::turn && control_.isStopped())
    screen_->showMessage(tr("Stopped"), tr("The force is off. Touch the screen to continue."));
}

void KioskWindow::stopDevice()
{
  if (control_.isDeviceActive()) letGo();
}

/// After a stop (the window lost the focus, the screen was locked) a visitor at the handle continues
/// by touching the screen.
void KioskWindow::continueTurn()
{
  if (stage_ != KioskStage::turn || !control_.isStopped() || !control_.begin()) return;
  inviteToTurn();
}

bool KioskWindow::isTouched() const { return screen_->isPressed() || pushedByKey_ != 0; }

void KioskWindow::stepTurn(double elapsed_s)
{
  const bool isHeld = isTouched();
  if (isHeld || (control_.input() == InputSource::device && control_.isMoving()))
    touchedAt_s_ = now_s();
  if (control_.input() == InputSource::pointer) {
    if (isHeld != control_.isHeld()) control_.hold(isHeld);
    const double speed = screen_->isPressed() ? screen_->speed().si() : pushedByKey_ * byKey.si();
    if (isHeld && control_.now().output.workflow == Workflow::inserting)
      control_.advanceBy(Length::fromSi(speed * elapsed_s));
  }
  turn_.follow(control_.now());
  if (control_.isAtDepth() || control_.now().output.workflow == Workflow::fault || hasEndedEarly())
    endTurn();
}

void KioskWindow::showPicture()
{
  const haptics::TickOutput& now = control_.now().output;
  const std::pair<double, double> seen{now.travel, now.axialForce};
  if (seen == drawn_) return;
  drawn_ = seen;
  screen_->view().showArray(control_.now());
}

void KioskWindow::onFrame()
{
  ++frames_;
  const double elapsed_s = std::min(double(sinceFrame_.restart()) / 1e3, longestStep_s);
  if (control_.update()) showPicture();
  if (stage_ == KioskStage::attract) stepAttract();
  if (stage_ == KioskStage::turn) stepTurn(elapsed_s);
  if (stage_ != KioskStage::attract && now_s() - touchedAt_s_ >= patience_s) beginAttract();
  screen_->view().stepCamera(elapsed_s);
  screen_->view().renderIfDirty();
  if (sinceSlow_.elapsed() < slowInterval_ms) return;
  sinceSlow_.restart();
  screen_->view().showNumbers(control_.now().output,
                              analysis::angularInsertionDepth(
                                  control_.anatomy(), control_.scenario().array(), control_.now()),
                              control_.scenario().stopTravel());
}

void KioskWindow::onPresented()
{
  if (!isFirstFrame_ || !timer_.isActive()) return;
  isFirstFrame_ = false;
  Q_EMIT firstFrameShown();
}

}  // namespace perilymph::gui
