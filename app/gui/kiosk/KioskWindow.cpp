// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/KioskWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "gui/kiosk/ArrayTour.h"
#include "gui/kiosk/DayView.h"
#include "gui/kiosk/LevelGauge.h"
#include "gui/run/InputChoice.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/StopTravel.h"
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
constexpr double station_s = 7.0;  // duration of each camera view: two lines are read in it
constexpr double rest_s = 4.0;     // pause at full depth before the insertion repeats
constexpr Speed byKey = millimetersPerSecond(2);
constexpr double sceneLetter_px = 12.0;  // of SceneStyle::textScale 1

constexpr double movedTravel_m = 0.5e-3;  // from which on somebody who touched is a visitor

/// Camera views of the demonstration, in order.
constexpr std::array tour{CameraPreset::surgeon, CameraPreset::overview, CameraPreset::followTip,
                          CameraPreset::surgeon};

/// What is to be seen from each of them, in plain words.
std::array<QString, tour.size()> tourSentences(const session::Scenario& scenario)
{
  return {
      KioskWindow::tr("A cochlear implant lets deaf people hear. A surgeon slides its array of "
                      "electrodes into the inner ear by hand."),
      arraySentence(scenario),
      KioskWindow::tr("The wall glows where the array presses on it. A gentle hand protects the "
                      "hearing that is left."),
      KioskWindow::tr("The inner ear is as small as a pea, and its opening measures one to two "
                      "millimeters.")};
}

/// "Nucleus Slim Straight" of "Nucleus Slim Straight (CI422, CI522, CI622)".
QString shortName(const electrode::ArrayDesign& array)
{
  return QString::fromStdString(array.name).section(QStringLiteral(" ("), 0, 0);
}

std::optional<analysis::PrintedRange> rangeOfLevels()
{
  const auto peaks = analysis::peaksInPatients();
  return peaks ? std::optional(*peaks) : std::nullopt;
}

}  // namespace

KioskWindow::KioskWindow(session::Scenario scenario, std::filesystem::path board, KioskClock clock,
                         std::shared_ptr<CochleaStore> cochleae)
    : control_(std::move(scenario), std::nullopt, std::move(cochleae)),
      clock_(std::move(clock)),
      board_(std::move(board)),
      peaks_(rangeOfLevels()),
      language_(QLocale().name()),
      screen_(new KioskScreen(this))
{
  control_.disableRecording();
  setObjectName(QStringLiteral("kioskWindow"));
  setWindowTitle(tr("Perilymph"));
  setFont(typeface(16));
  setStyleSheet(windowStyle());
  setMinimumSize(560, 360);  // a screen of 1366x768 at scale 2 has 683x384
  resize(1280, 800);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::PreventContextMenu);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(screen_);
  screen_->day().setRange(peaks_);
  screen_->gauge().setRange(peaks_);
  if (peaks_) screen_->setSource(levelSource(*peaks_));
  connect(screen_, &KioskScreen::startOverRequested, this, [this] { beginTurn(control_.input()); });
  connect(screen_, &KioskScreen::handleRequested, this, &KioskWindow::chooseHandle);
  connect(screen_, &KioskScreen::leaveRequested, this, &KioskWindow::beginAttract);
  connect(screen_, &KioskScreen::stopRequested, this, &KioskWindow::letGo);
  connect(screen_, &KioskScreen::otherLanguageRequested, this, &KioskWindow::requestOtherLanguage);
  connect(screen_, &KioskScreen::letterSizeChanged, this, &KioskWindow::showScene);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(frameInterval_ms);
  connect(&timer_, &QTimer::timeout, this, &KioskWindow::onFrame);
  connect(&screen_->view(), &PlainVtkWidget::presented, this, &KioskWindow::onPresented);
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
      if (screen_->isLanguage(target)) return false;
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
  if (event->key() == Qt::Key_L) {
    requestOtherLanguage();
  } else if (stage_ == KioskStage::attract) {
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

void KioskWindow::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void KioskWindow::requestOtherLanguage()
{
  touchedAt_s_ = now_s();
  const bool isGerman = QLocale().language() == QLocale::German;
  Q_EMIT languageRequested(isGerman ? QStringLiteral("en") : QStringLiteral("de"));
}

void KioskWindow::retranslate()
{
  if (peaks_) screen_->setSource(levelSource(*peaks_));
  screen_->retranslate();
  showMessage(message_);
  if (reached_) screen_->showCode(takeAway());
}

Result<void> KioskWindow::open()
{
  const Result<void> prepared = control_.prepare(InputSource::scripted);
  if (!prepared) return prepared;
  for (session::Scenario& scenario : arrayTour(control_.scenario())) {
    auto model = session::buildModel(scenario, control_.sharedAnatomy());
    if (!model) continue;
    tour_.push_back(scenario);
    parts_.push_back({control_.sharedAnatomy(), *std::move(model)});
  }
  showScene();
  sinceFrame_.start();
  sinceSlow_.start();
  timer_.start();
  beginAttract();
  return {};
}

/// The scene of the present array in the present size of type.
void KioskWindow::showScene()
{
  if (tour_.empty()) return;
  const session::Scenario& scenario = tour_[shown_];
  drawn_ = shown_;
  visualization::SceneStyle style =
      sceneStyle(shownColorScheme(), screen_->letterSize() / sceneLetter_px);
  style.hasForceScale = false;  // visitors know no millinewtons
  auto scene = std::make_unique<visualization::InsertionScene>(
      control_.anatomy(), scenario.array(), scenario.patient().side,
      visualization::Quality::software, style);
  scene->setVisible(visualization::Part::contactArrows, false);
  OperationView& view = screen_->view();
  if (view.scene() == nullptr)
    view.setScene(std::move(scene));
  else
    view.replaceScene(std::move(scene));
  view.setPartial(outsideAtStop(scenario).si() > 0.0);
  view.showArray(control_.now());
}

/// The next insertion is one of the demonstration's; the visitors' is the first.
void KioskWindow::use(std::size_t demonstration)
{
  shown_ = demonstration;
  control_.use(tour_[shown_], parts_[shown_]);
}

void KioskWindow::setStage(KioskStage stage)
{
  stage_ = stage;
  stageAt_s_ = now_s();
  touchedAt_s_ = now_s();
  screen_->showStage(stage);
  setFocus();
}

void KioskWindow::showDay()
{
  const QDate today = clock_.today().date();
  DayView::Content content{board_.statisticsOf(today), board_.entriesOf(today), std::nullopt};
  if (reached_ && reached_->taken.rank > 0) content.chosen = reached_->taken.rank;
  screen_->day().show(std::move(content));
}

bool KioskWindow::prepare(InputSource input)
{
  letGo();
  turn_ = {};
  const Result<void> prepared = control_.prepare(input);
  const Result<void> begun = prepared ? control_.begin() : prepared;
  screen_->view().setBanner(begun ? QString() : dataText(begun.error().message));
  if (prepared && drawn_ != shown_) showScene();
  if (prepared) screen_->view().showArray(control_.now());
  return static_cast<bool>(begun);
}

void KioskWindow::beginAttract()
{
  const bool isAnew = stage_ != KioskStage::attract || station_ < 0;
  restingAt_s_.reset();
  use(isAnew ? 0 : (shown_ + 1) % tour_.size());
  // if preparation fails, it is repeated after the pause
  if (!prepare(InputSource::scripted)) restingAt_s_ = now_s();
  stageAt_s_ = now_s();
  station_ = -1;
  if (!isAnew) return;
  if (QLocale().name() != language_) Q_EMIT languageRequested(language_);
  isCounted_ = false;
  leaveResult();
  setStage(KioskStage::attract);
  showDay();
}

void KioskWindow::leaveResult()
{
  reached_.reset();
  message_ = Message::attract;  // until the next one is shown
  screen_->showCode({});
}

void KioskWindow::stepAttract()
{
  const int station = int((now_s() - stageAt_s_) / station_s) % int(tour.size());
  if (station != station_) {
    station_ = station;
    screen_->view().glideTo(tour[std::size_t(station)]);
    showMessage(Message::attract);
  }
  const Workflow workflow = control_.now().output.workflow;
  const bool isOver = control_.isAtDepth() || workflow == Workflow::fault || hasEndedEarly();
  if (isOver && !restingAt_s_) restingAt_s_ = now_s();
  if (restingAt_s_ && now_s() - *restingAt_s_ >= rest_s) beginAttract();
}

void KioskWindow::chooseHandle()
{
  if (control_.input() == InputSource::device) return beginTurn(InputSource::pointer);
  // The device chosen in the workstation, else any.
  if (auto remembered = rememberedInput()) return useDevice(*std::move(remembered));
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
      rememberedInput().has_value() ||
      std::any_of(survey.devices.begin(), survey.devices.end(),
                  [](const device::FoundDevice& each) { return each.isUsable(); }));
  if (input == InputSource::scripted) input = InputSource::pointer;
  leaveResult();
  setStage(KioskStage::turn);
  use(0);
  if (!prepare(input)) {
    if (input == InputSource::device) return beginTurn(InputSource::pointer);
    showMessage(Message::unavailable);
    return setStage(KioskStage::result);
  }
  screen_->useHandle(input == InputSource::device);
  screen_->view().glideTo(CameraPreset::surgeon);
  showMessage(Message::invite);
}

void KioskWindow::showMessage(Message message)
{
  message_ = message;
  switch (message) {
    case Message::attract:
      return showDemonstration();
    case Message::invite:
      return screen_->showMessage(
          tr("Your turn"),
          control_.input() == InputSource::device
              ? tr("Hold the device button and advance. Stay gentle until the goal.")
              : tr("Hold the bar to insert; further right is faster. Stay gentle until the goal."));
    case Message::stopped:
      return screen_->showMessage(tr("Stopped"),
                                  tr("The force is off. Touch the screen to continue."));
    case Message::unavailable:
      return screen_->showMessage(tr("Not available now"), tr("Please ask the booth staff."));
    case Message::unstable:
      return screen_->showMessage(
          tr("The insertion was stopped"),
          tr("The simulation became unstable and was stopped. The force is off. Try again."));
    case Message::stuck:
      return screen_->showMessage(
          tr("The array is stuck"),
          tr("It bent or jammed before the goal. The force is off. Try again, slower."));
    case Message::reached:
      return showReached();
  }
}

void KioskWindow::showDemonstration()
{
  const session::Scenario& scenario = tour_[shown_];
  const int station = std::max(0, station_);
  screen_->showMessage(tr("Cochlear implant: %1").arg(shortName(scenario.array())),
                       tourSentences(scenario)[std::size_t(station)]);
}

void KioskWindow::showReached()
{
  const auto& [entry, taken] = *reached_;
  const bool isFull = outsideAtStop(control_.scenario()).si() <= 0.0;
  QStringList title{isFull ? tr("Full depth reached") : tr("Goal reached")};
  if (taken.level) title << signOf(*taken.level) + QLatin1Char(' ') + wordOf(*taken.level);
  if (taken.rank > 0) title << tr("rank %1 of %2 today").arg(taken.rank).arg(taken.insertions);
  const QString peak = numberText(entry.peak_mN, 0), time = numberText(entry.duration_s, 0);
  const QString sentence = entry.reversals == 0
                               ? tr("Peak force %1 mN in %2 s, no reversals.").arg(peak, time)
                               : tr("Peak force %1 mN in %2 s, reversals: %3.")
                                     .arg(peak, time, QString::number(entry.reversals));
  screen_->showMessage(
      title.join(QStringLiteral(" · ")),
      taken.level ? sentence + QLatin1Char(' ') + sentenceOf(*taken.level) : sentence);
}

bool KioskWindow::hasEndedEarly() const
{
  return control_.earlyEnd() != haptics::InsertionEnd::none;
}

void KioskWindow::endTurn()
{
  letGo();
  setStage(KioskStage::result);
  if (control_.now().output.workflow == Workflow::fault) {
    showMessage(Message::unstable);
  } else if (hasEndedEarly()) {
    showMessage(Message::stuck);
  } else {
    reached_ = reachedGoal();
    screen_->showCode(takeAway());
    showMessage(Message::reached);
  }
  showDay();
  if (!board_.error().empty()) screen_->view().setBanner(QString::fromStdString(board_.error()));
}

/// Enters the insertion in the list of the day.
KioskWindow::Reached KioskWindow::reachedGoal()
{
  const session::Scenario& scenario = control_.scenario();
  const QDateTime today = clock_.today();
  Reached reached;
  reached.entry = {today.time(), inMillinewtons(newtons(turn_.peakForce())), turn_.duration(),
                   turn_.reversals()};
  reached.taken = {shortName(scenario.array()),
                   meters(turn_.deepest()),
                   newtons(turn_.peakForce()),
                   std::nullopt,
                   board_.enter(today.date(), reached.entry).value_or(0),
                   board_.statisticsOf(today.date()).insertions,
                   takeAwayCurve(turn_.curve(), scenario.startInside())};
  if (peaks_) reached.taken.level = levelOf(turn_.peakForce(), *peaks_);
  return reached;
}

QString KioskWindow::takeAway() const
{
  return reached_ ? takeAwayText(reached_->taken) : QString();
}

void KioskWindow::letGo()
{
  pushedByKey_ = 0;
  control_.pause();
  screen_->release();
  if (stage_ == KioskStage::turn && control_.isStopped()) showMessage(Message::stopped);
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
  showMessage(Message::invite);
}

bool KioskWindow::isTouched() const { return screen_->isPressed() || pushedByKey_ != 0; }

void KioskWindow::stepTurn()
{
  const bool isHeld = isTouched();
  if (isHeld || (control_.input() == InputSource::device && control_.isMoving()))
    touchedAt_s_ = now_s();
  if (control_.input() == InputSource::pointer) {
    if (isHeld != control_.isHeld()) control_.hold(isHeld);
    const double speed = screen_->isPressed() ? screen_->speed().si() : pushedByKey_ * byKey.si();
    control_.driveAt(Speed::fromSi(speed));  // timed by the loop, however slow the pictures are
  }
  turn_.follow(control_.now());
  if (!isCounted_ && turn_.deepestTravel() >= movedTravel_m) {
    isCounted_ = true;
    board_.addVisitor(clock_.today().date());
  }
  if (control_.isAtDepth() || control_.now().output.workflow == Workflow::fault || hasEndedEarly())
    endTurn();
}

void KioskWindow::showPicture()
{
  const haptics::TickOutput& now = control_.now().output;
  const std::pair<double, double> seen{now.travel, now.axialForce};
  if (seen == seen_) return;
  seen_ = seen;
  screen_->view().showArray(control_.now());
}

void KioskWindow::onFrame()
{
  ++frames_;
  const double elapsed_s = std::min(double(sinceFrame_.restart()) / 1e3, longestStep_s);
  if (control_.update()) showPicture();
  if (stage_ == KioskStage::attract) stepAttract();
  if (stage_ == KioskStage::turn) stepTurn();
  if (stage_ != KioskStage::attract && now_s() - touchedAt_s_ >= patience_s) beginAttract();
  screen_->view().stepCamera(elapsed_s);
  screen_->view().renderIfDirty();
  if (sinceSlow_.elapsed() < slowInterval_ms) return;
  sinceSlow_.restart();
  screen_->gauge().show(control_.now().output.axialForce, control_.now().peak.force);
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
