// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertionController.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "gui/pages/insert/InsertionText.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/run/ScenarioDifference.h"
#include "gui/run/WorkflowPredicates.h"
#include "gui/setup/PatientSetup.h"
#include "gui/text/DataText.h"

namespace perilymph::gui {

InsertionController::InsertionController(session::Scenario scenario,
                                         std::optional<std::filesystem::path> record,
                                         std::shared_ptr<CochleaStore> cochleae)
    : control_(std::move(scenario), std::move(record), std::move(cochleae)),
      safety_(control_),
      setup_(new SetupControl(control_, this)),
      replay_(new ReplayPlayer(this)),
      held_(control_),
      reading_(this),
      opening_(this)
{
  connectSetup();
  openingTimer_.setInterval(1000);
  connect(&openingTimer_, &QTimer::timeout, this, &InsertionController::openingChanged);
  connect(replay_, &ReplayPlayer::opened, this, &InsertionController::beginReplay);
  connect(replay_, &ReplayPlayer::failed, this, &InsertionController::replayFailed);
  setup_->history().begin({control_.scenario(), {}}, SetupOrigin::Kind::preset);
}

InsertionController::~InsertionController() = default;

void InsertionController::connectSetup()
{
  SetupHistory* history = &setup_->history();
  connect(history, &SetupHistory::setupChanged, this, [this] {
    Q_EMIT setupChanged();
    setup_->follow();
  });
  connect(history, &SetupHistory::refused, this, &InsertionController::showError);
  connect(setup_, &SetupControl::ready, this, &InsertionController::use);
  connect(setup_, &SetupControl::failed, this, &InsertionController::showError);
  connect(setup_, &SetupControl::followed, this, [this] {
    if (loading_ && !setup_->isBuilding()) setLoading(std::nullopt);
    Q_EMIT stateChanged();
    Q_EMIT subjectChanged();
  });
}

Result<void> InsertionController::open()
{
  control_.use(control_.scenario(), setup_->takeFirst());
  const Result<void> ready = control_.prepare(InputSource::scripted);
  if (!ready) return ready;
  Q_EMIT cochleaChanged();
  Q_EMIT prepared();
  if (inputBefore_ != InputSource::scripted) prepare(inputBefore_);
  Q_EMIT opened();
  return {};
}

InsertionController::Memory InsertionController::memory() const
{
  return {history().memory(), reference_, replay_->isOpen() ? inputBefore_ : control_.input(),
          control_.chosen(), plan_};
}

void InsertionController::resume(const Memory& memory)
{
  setup_->history().resume(memory.setup);
  setReference(memory.ghost);
  plan_ = memory.plan;
  Q_EMIT planChanged();
  control_.choose(memory.device);
  inputBefore_ = memory.input;
  Q_EMIT subjectChanged();
}

void InsertionController::load(const InsertionRequest& request)
{
  if (request.plan) {
    plan_ = request.plan;
    Q_EMIT planChanged();
  }
  pause();
  closeReplay();
  setLoading(request.setup.scenario);
  setup_->build(request.setup.scenario, [this, request](const InsertionControl::Parts& parts) {
    Q_EMIT cochleaEnding();
    loading_.reset();
    control_.use(request.setup.scenario, parts);
    setup_->history().begin(request.setup, request.kind);
    Q_EMIT subjectChanged();
    prepare(InputSource::scripted);
    Q_EMIT cochleaChanged();
    if (request.then == AfterLoading::insert) start();
  });
}

const session::Scenario* InsertionController::shownInstead() const
{
  if (loading_) return &*loading_;
  return replay_->isOpen() ? &replay_->playback().scenario() : nullptr;
}

void InsertionController::setLoading(const std::optional<session::Scenario>& scenario)
{
  loading_ = scenario;
  Q_EMIT stateChanged();
  Q_EMIT subjectChanged();
}

void InsertionController::loadPatient(const anatomy::Patient& patient)
{
  if (!maySetUp()) return;
  const session::Scenario& now = history().now().scenario;
  auto setup = setupOfPatient(patient, now.patient().basalTurn ? &now : nullptr);
  if (!setup) return showError(dataText(setup.error().message));
  // a line of approach was turned in another ear
  if (now.patient().label != patient.label || now.patient().side != patient.side) {
    auto along = withApproach(setup->scenario, {});
    if (!along) return showError(dataText(along.error().message));
    setup->scenario = *std::move(along);
  }
  load({*setup});
}

void InsertionController::use(const session::Scenario& scenario,
                              const std::optional<InsertionControl::Parts>& parts)
{
  const bool looksTheSame = lookAlike(scenario, control_.scenario());
  if (!looksTheSame) Q_EMIT cochleaEnding();
  control_.use(scenario, parts);
  Q_EMIT subjectChanged();
  prepare(control_.input());
  if (!looksTheSame) Q_EMIT cochleaChanged();
  if (setup_->isStartRequested()) start();
}

bool InsertionController::maySetUp() const
{
  return gui::maySetUp(stateOf(control_)) && !setup_->isStartRequested() && !replay_->isOpen();
}

void InsertionController::change(const SetupChange& change)
{
  if (maySetUp()) Q_EMIT noted(setup_->change(change));
}

void InsertionController::restore()
{
  if (maySetUp()) setup_->history().restore();
}

void InsertionController::undo()
{
  if (maySetUp() && history().stack().canUndo()) setup_->history().undo();
}

void InsertionController::redo()
{
  if (maySetUp() && history().stack().canRedo()) setup_->history().redo();
}

void InsertionController::start()
{
  if (!openingName_.isEmpty()) return Q_EMIT noted(openingText());
  if (isDeviceMissing_)
    return showError(
        tr("The chosen device is not open, so that Start would insert by the script. Press "
           "Reset to open the device again, or choose the script as the input."));
  // Edited values are committed, and the result is built first.
  const QString refused = maySetUp() && commit_ ? commit_() : QString();
  if (!refused.isEmpty()) return showError(refused);
  setup_->history().seal();
  rememberArray(history().now().scenario);
  setup_->startWhenBuilt(setup_->isBuilding());
  if (setup_->isBuilding()) return stateChanged();
  const Result<void> begun = control_.begin();
  if (!begun) showError(dataText(begun.error().message));
  Q_EMIT stateChanged();
}

void InsertionController::pause()
{
  control_.pause();
  setup_->startWhenBuilt(false);
  held_.letGo();
  Q_EMIT stateChanged();
}

bool InsertionController::rest()
{
  if (!control_.isMoving() && !control_.isHeld() && !control_.isDeviceActive()) return false;
  pause();
  return true;
}

void InsertionController::withdraw()
{
  control_.withdraw();
  Q_EMIT stateChanged();
}

void InsertionController::reset()
{
  prepare(isDeviceMissing_ ? InputSource::device : control_.input());
}

void InsertionController::again()
{
  reset();
  if (control_.input() == InputSource::scripted) start();
}

void InsertionController::followEnd()
{
  const auto workflow = control_.now().output.workflow;
  if (isResultRequested_ && !isOver(workflow)) return discardResult();  // it is withdrawn
  // a rest that was recorded further is read again
  const double time = control_.now().output.time;
  if (control_.progress() != Progress::concluded || (isResultRequested_ && time == readUpTo_))
    return;
  const auto file = control_.recording();
  if (!file) return;
  isResultRequested_ = true;
  readUpTo_ = time;
  auto plan = plan_ && plan_->isFor(control_.scenario()) ? plan_ : std::nullopt;
  reading_.run(
      "The result",
      [file = *file](const std::stop_token& stop) { return gatherReport(file, stop); },
      [this, plan = std::move(plan)](Result<ReportContent> read) {
        if (!read) return showError(dataText(read.error().message));
        if (plan) read->plan = plan;  // the one that is shown during the insertion
        read->mayGoOn = true;
        result_ = std::make_shared<const ReportContent>(*std::move(read));
        Q_EMIT resultChanged();
      });
}

void InsertionController::discardResult()
{
  isResultRequested_ = false;
  reading_.cancel();
  result_.reset();
  Q_EMIT resultChanged();
}

void InsertionController::pressSpace()
{
  if (control_.input() == InputSource::pointer) {
    if (!control_.isRunning()) start();
    held_.hold(true);
  } else if (control_.isMoving() || control_.isDeviceActive()) {
    pause();
  } else {
    start();
  }
}

bool InsertionController::stopDevice()
{
  if (!safety_.stopDevice()) return false;
  Q_EMIT stateChanged();
  return true;
}

void InsertionController::loseKeyboard()
{
  safety_.loseKeyboard();
  held_.letGo();
}

void InsertionController::chooseInput(InputSource input)
{
  if (input != control_.input() || isDeviceMissing_ || !openingName_.isEmpty()) prepare(input);
}

void InsertionController::prepare(InputSource input)
{
  endOpening();
  isDeviceMissing_ = false;
  if (input == InputSource::device && !control_.chosen().slowName.empty())
    return openInBackground();
  prepareNow(input);
}

void InsertionController::prepareNow(InputSource input)
{
  error_.clear();
  held_.letGo();
  if (control_.isRunning()) before_ = control_.recording();
  discardResult();
  const Result<void> ready = control_.prepare(input);
  if (!ready && input == InputSource::device) {
    // If a device cannot be opened, the script remains the input device.
    prepareNow(InputSource::scripted);
    isDeviceMissing_ = true;
    return showError(dataText(ready.error().message));
  }
  if (!ready) return showError(dataText(ready.error().message));
  Q_EMIT prepared();
}

void InsertionController::openInBackground()
{
  using Opened = Result<std::shared_ptr<device::HapticDevice>>;
  // no force of the device before while another one is opened
  prepareNow(InputSource::scripted);
  const auto factory = control_.chosen();
  openingName_ = QString::fromStdString(factory.slowName);
  openingSince_.start();
  openingTimer_.start();
  const auto isOpened = std::make_shared<std::promise<void>>();
  const auto opened = isOpened->get_future();
  opening_.run(
      "The device",
      [factory, isOpened](const std::stop_token& stop) -> Opened {
        auto made = factory.make(stop);
        auto result = [&]() -> Opened {
          if (!made) return made.error();
          if (const auto done = (*made)->open(); !done) return done.error();
          return std::shared_ptr<device::HapticDevice>(*std::move(made));
        }();
        isOpened->set_value();
        return result;
      },
      [this](Opened device) {
        endOpening();
        if (!device) {
          isDeviceMissing_ = true;
          return showError(dataText(device.error().message));
        }
        control_.takeOpened(*std::move(device));
        prepareNow(InputSource::device);
      });
  // Most are open at once; the window is not blocked for longer.
  constexpr std::chrono::milliseconds unnoticed{250};
  if (opened.wait_for(unnoticed) == std::future_status::ready) return opening_.finish();
  Q_EMIT openingChanged();
}

void InsertionController::endOpening()
{
  if (openingName_.isEmpty()) return;
  opening_.cancel();
  openingTimer_.stop();
  openingName_.clear();
  Q_EMIT openingChanged();
}

QString InsertionController::openingText() const
{
  if (openingName_.isEmpty()) return {};
  const auto time_s = openingSince_.elapsed() / 1000;
  if (time_s < 2) return tr("%1 is being opened.").arg(openingName_);
  return tr("%1 has not answered for %2 s. Check its power and its cable, or cancel.")
      .arg(openingName_)
      .arg(time_s);
}

bool InsertionController::cancelOpening()
{
  if (openingName_.isEmpty()) return false;
  endOpening();
  Q_EMIT noted(tr("The device was not opened. The input is the scripted insertion."));
  return true;
}

void InsertionController::openReplay(const std::filesystem::path& file)
{
  if (replay_->isOpen()) Q_EMIT cochleaEnding();
  replay_->open(file);
}

void InsertionController::beginReplay()
{
  // Only the display may move: the insertion ends, and no device remains open.
  setup_->abandon();
  inputBefore_ = control_.input();
  prepare(InputSource::scripted);
  Q_EMIT replayOpened();
  Q_EMIT subjectChanged();
}

void InsertionController::closeReplay()
{
  if (!replay_->isOpen()) return;
  Q_EMIT cochleaEnding();
  replay_->close();
  Q_EMIT replayClosed();
  Q_EMIT subjectChanged();
  prepare(inputBefore_);
  Q_EMIT cochleaChanged();
  Q_EMIT setupChanged();
  setup_->follow();  // a change that was being built when the replay began
}

void InsertionController::setReference(const std::optional<ReferenceInsertion>& reference)
{
  reference_ = reference;
  Q_EMIT referenceChanged();
}

void InsertionController::showError(const QString& sentence)
{
  spdlog::warn("{}", sentence.toStdString());
  error_ = sentence;
  Q_EMIT errorChanged();
}

QString InsertionController::error() const { return errorText(control_, error_); }

}  // namespace perilymph::gui
