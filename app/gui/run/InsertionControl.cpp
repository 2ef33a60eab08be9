// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/InsertionControl.h"

#include <spdlog/spdlog.h>
#include <algorithm>

#include <cmath>
#include <utility>

#include "gui/run/RecordingName.h"
#include "gui/run/WorkflowPredicates.h"
#include "perilymph/device/PluginDevice.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/realtime/Pacer.h"

namespace perilymph::gui {

namespace {

using Kind = haptics::Command::Kind;
using Motion = device::ScriptedMotion;

}  // namespace

InsertionControl::InsertionControl(session::Scenario scenario,
                                   std::optional<std::filesystem::path> record,
                                   std::shared_ptr<CochleaStore> cochleae)
    : scenario_(std::move(scenario)), cochleae_(std::move(cochleae)), record_(std::move(record))
{
}

InsertionControl::~InsertionControl() { discard(); }

std::filesystem::path InsertionControl::nextRecording()
{
  // Only the first insertion uses a requested file name; all others get a new name.
  if (record_ && prepared_ == 1) return *record_;
  return record_ ? besides(*record_) : newRecording(scenario_.name());
}

void InsertionControl::use(session::Scenario scenario, const std::optional<Parts>& parts)
{
  scenario_ = std::move(scenario);
  if (!parts) return;
  anatomy_ = parts->anatomy;
  model_ = parts->model;
}

Result<void> InsertionControl::prepare(InputSource input)
{
  const auto done = prepareOnce(input);
  opened_.reset();
  return done;
}

Result<void> InsertionControl::prepareOnce(InputSource input)
{
  // A requested file name is kept for the first insertion that runs.
  const bool waits = record_ && insertion_ && prepared_ == 1 && !isRunning_;
  const auto waiting = waits ? recording() : std::nullopt;
  discard();
  std::error_code ignored;  // an error is reported when the file is opened
  if (waiting && std::filesystem::remove(*waiting, ignored)) --prepared_;
  ++prepared_;
  if (keepsNothing_) return build(input, std::nullopt);
  const std::filesystem::path file = nextRecording();
  if (!record_) std::filesystem::create_directories(file.parent_path(), ignored);
  const Result<void> recorded = build(input, file);
  const bool isRequested = record_ && prepared_ == 1;  // then it is mandatory
  if (recorded || isRequested) return recorded;

  // Any other insertion runs without a recording, with a message, if it cannot be created.
  const Result<void> unrecorded = build(input, std::nullopt);
  if (!unrecorded) return unrecorded;
  recordingError_ = recorded.error().message;
  return {};
}

void InsertionControl::discard()
{
  // An insertion that never ran leaves no file, unless the file was requested.
  const auto unused = isRunning_ || record_ ? std::nullopt : recording();
  insertion_.reset();  // closes its recording before the next one is opened
  pointer_.reset();
  isRunning_ = false;
  recordingError_.clear();
  std::error_code ignored;
  if (unused) std::filesystem::remove(*unused, ignored);
}

void InsertionControl::choose(const device::FoundDevice& found)
{
  chosen_ = [found]() -> Result<std::unique_ptr<device::HapticDevice>> {
    auto made = device::makeHidDevice(found, device::systemRoots());
    if (!made) return made.error();
    return std::unique_ptr<device::HapticDevice>(*std::move(made));
  };
}

void InsertionControl::choose(const std::filesystem::path& plugin)
{
  chosen_ = DeviceFactory::slow(plugin.stem().string(), [plugin](const std::stop_token& stop) {
    return device::loadPluginDevice(plugin, device::patienceForLoading, stop);
  });
}

InsertionControl::DeviceFactory InsertionControl::DeviceFactory::slow(
    std::string name, std::function<Made(const std::stop_token&)> make)
{
  DeviceFactory factory = [make] { return make({}); };
  factory.slowName = std::move(name);
  factory.make = std::move(make);
  return factory;
}

Result<void> InsertionControl::build(InputSource input, std::optional<std::filesystem::path> file)
{
  std::shared_ptr<device::HapticDevice> device;
  std::shared_ptr<device::PointerDevice> pointer;
  const double timeStep = scenario_.timeStep().si();
  if (input == InputSource::scripted) {
    device = std::make_shared<device::ScriptedDevice>(scenario_.speed().si(), timeStep);
  } else if (input == InputSource::device) {
    if (!chosen_) return Error{"No device was chosen. Press H and choose one."};
    device = opened_;
    if (!device) {
      auto made = chosen_();
      if (!made) return made.error();
      device = *std::move(made);
    }
  } else {
    device = pointer = std::make_shared<device::PointerDevice>(timeStep);
  }

  if (!anatomy_) {
    auto built = cochleae_->cochleaOf(scenario_);
    if (!built) return built.error();
    anatomy_ = *std::move(built);
  }
  auto prepared =
      session::Insertion::prepare(scenario_, std::move(device), std::move(file), anatomy_, model_);
  if (!prepared) return prepared.error();

  insertion_ = *std::move(prepared);
  anatomy_ = insertion_->sharedAnatomy();
  model_ = insertion_->sharedModel();
  pointer_ = std::move(pointer);
  input_ = input;
  wish_ = PendingRequest::rest;
  isHeld_ = false;
  isStopAwaited_ = false;
  isResuming_ = false;
  styletTarget_.reset();
  styletRequested_ = false;
  askedAt_ = 0;
  conclusion_ = {};
  now_ = haptics::Snapshot{};
  insertion_->loop().engine().fill(now_);  // no thread runs yet
  if (now_.output.depth > 0.0) now_.output.angularDepth = angleOfTip(*anatomy_, now_);
  return {};
}

Result<void> InsertionControl::begin()
{
  if (!insertion_) return Error{"No insertion is prepared. Press Reset."};
  if (!isRunning_) {
    const Result<void> started = insertion_->start();
    if (!started) return started;
    if (const Sentence note = insertion_->memoryNote(); !note.empty()) spdlog::info("{}", note);
    isRunning_ = true;
  }
  wish_ = PendingRequest::insert;
  continueDevice();
  isResuming_ = input_ == InputSource::device;
  applyPendingRequest();
  return {};
}

void InsertionControl::pause()
{
  if (input_ == InputSource::device && isRunning_) {
    insertion_->requestStop();
    isStopAwaited_ = true;
    isResuming_ = false;
    // The stop also ends a withdrawal of the stylet.
    if (styletTarget_ && now_.output.styletWithdrawal < *styletTarget_) styletTarget_.reset();
    styletRequested_ = styletTarget_.has_value();
  }
  wish_ = PendingRequest::rest;
  hold(false);
  moveScripted(Motion::hold);
}

void InsertionControl::stopDeviceAfter(Duration time)
{
  if (input_ != InputSource::device || !isRunning_) return;
  insertion_->requestStopAt(realtime::monotonicNanoseconds() + std::llround(time.si() * 1e9));
}

void InsertionControl::continueDevice()
{
  if (input_ == InputSource::device && isRunning_) insertion_->cancelStopAt();
}

void InsertionControl::withdraw()
{
  if (!isRunning_) return;
  wish_ = PendingRequest::withdraw;
  isResuming_ = input_ == InputSource::device;
  applyPendingRequest();
}

void InsertionControl::pullStylet()
{
  const bool isArmed = isRunning_ && now_.output.workflow != haptics::Workflow::idle;
  if (!isArmed || !scenario_.array().hasStylet) return;
  styletTarget_ = scenario_.array().length.si();
  applyPendingRequest();
}

void InsertionControl::hold(bool isHeld)
{
  if (pointer_ == nullptr) return;
  isHeld_ = isHeld && isRunning_;
  pointer_->grasp(isHeld_);
}

void InsertionControl::advanceBy(Length distance)
{
  if (pointer_ == nullptr || !isHeld_) return;
  if (distance.si() > 0.0 && isAtDepth()) return;
  pointer_->advanceBy(distance.si());
}

void InsertionControl::driveAt(Speed speed)
{
  if (pointer_ == nullptr) return;
  const double ahead = scenario_.stopTravel().si() - now_.output.travel;
  const double behind = std::max(0.0, now_.output.depth);  // until the tip is out
  pointer_->driveAt(isHeld_ ? speed.si() : 0.0, speed.si() > 0.0 ? ahead : behind);
}

bool InsertionControl::update()
{
  if (!isRunning_) return false;
  const bool isNew = insertion_->refresh();
  if (isNew) now_ = insertion_->latest();
  const bool isStopShown = (now_.output.status & haptics::stopped) != 0;
  if (isStopShown) isStopAwaited_ = false;
  if (isStopShown && !isResuming_) wish_ = PendingRequest::rest;
  if (!isStopShown && !isStopAwaited_) isResuming_ = false;
  applyPendingRequest();
  if (conclusion_.isDue(now_.output)) insertion_->concludeRecording();
  return isNew;
}

Progress InsertionControl::progress() const noexcept
{
  if (!isRunning_) return Progress::ready;
  if (!isOver(now_.output.workflow)) return Progress::underway;
  const bool isClosed = conclusion_.isRequested() && insertion_->isRecordingConcluded();
  return isClosed ? Progress::concluded : Progress::resting;
}

bool InsertionControl::ask(Kind kind, double value)
{
  haptics::Command command;
  command.kind = kind;
  command.value = value;
  return insertion_->send(command);
}

void InsertionControl::applyPendingRequest()
{
  const haptics::Workflow workflow = now_.output.workflow;
  if (workflow == haptics::Workflow::fault) {
    moveScripted(Motion::hold);
    wish_ = PendingRequest::rest;
    return;
  }
  if (isResuming_) pursueResumption();
  if (wish_ == PendingRequest::rest && !styletTarget_) return;

  if (workflow == haptics::Workflow::idle) {
    if (now_.tick >= askedAt_ && ask(Kind::arm)) askedAt_ = now_.tick + 1;
    return;
  }
  if (styletTarget_ && !styletRequested_) styletRequested_ = ask(Kind::pullStylet, *styletTarget_);

  if (wish_ == PendingRequest::insert) {
    const bool isDone = workflow == haptics::Workflow::finished || isAtDepth();
    moveScripted(isDone ? Motion::hold : Motion::insert);
    if (isDone) wish_ = PendingRequest::rest;
  } else if (wish_ == PendingRequest::withdraw) {
    pursueWithdrawal();
  }
}

void InsertionControl::pursueResumption()
{
  const bool isStopShown = (now_.output.status & haptics::stopped) != 0;
  if (isStopShown && now_.tick >= askedAt_ && ask(Kind::resume)) askedAt_ = now_.tick + 1;
}

void InsertionControl::pursueWithdrawal()
{
  if (isStopped()) return;  // resumed first
  const haptics::TickOutput& now = now_.output;
  // At full depth and after an early end the loop needs a command; before that the scripted device
  // reverses on its own.
  const bool isInside = isAtDepth() || earlyEnd() != haptics::InsertionEnd::none;
  if (now.workflow == haptics::Workflow::finished && isInside) {
    if (now_.tick >= askedAt_ && ask(Kind::withdraw)) askedAt_ = now_.tick + 1;
    return;
  }
  const bool isOut = now.travel <= 0.0 || now.workflow == haptics::Workflow::finished;
  moveScripted(isOut ? Motion::hold : Motion::withdraw);
  if (isOut) wish_ = PendingRequest::rest;
}

bool InsertionControl::isAtDepth() const noexcept
{
  // Also after a withdrawal from full depth, when the stop no longer applies. A finished withdrawal
  // is finished, too, but near the start.
  const double stop = scenario_.stopTravel().si();
  const bool isFinished = now_.output.workflow == haptics::Workflow::finished;
  return now_.output.travel >= stop || (isFinished && now_.output.travel > 0.5 * stop);
}

haptics::InsertionEnd InsertionControl::earlyEnd() const noexcept
{
  const haptics::TickOutput& now = now_.output;
  const bool isOver = now.workflow == haptics::Workflow::finished;
  // Withdrawn to its start, or less: the tip may also be out.
  constexpr double atStart = 1e-6;  // [m]
  const bool isBack = now.travel <= atStart && (now.status & haptics::endedOutOfOpening) == 0;
  if (!isOver || isBack || (now.status & haptics::anyEnd) == 0) return haptics::InsertionEnd::none;
  return endOf(now);
}

void InsertionControl::moveScripted(Motion motion)
{
  if (insertion_) insertion_->device().move(motion);
}

bool InsertionControl::isMoving() const noexcept
{
  if (input_ == InputSource::device) return now_.output.workflow == haptics::Workflow::inserting;
  return input_ == InputSource::pointer ? isHeld_ : wish_ != PendingRequest::rest;
}

bool InsertionControl::isDeviceActive() const noexcept
{
  return input_ == InputSource::device && isRunning_ && !isStopped() &&
         now_.output.workflow != haptics::Workflow::fault;
}

bool InsertionControl::isStopped() const noexcept
{
  const bool isStopShown = (now_.output.status & haptics::stopped) != 0;
  return input_ == InputSource::device && isRunning_ && (isStopAwaited_ || isStopShown);
}

bool InsertionControl::rendersForce() const
{
  return input_ == InputSource::device && insertion_ && insertion_->device().traits().rendersForce;
}

std::string InsertionControl::inputName() const
{
  return insertion_ ? insertion_->device().traits().name : std::string();
}

std::optional<device::DeviceHealth> InsertionControl::deviceHealth() const
{
  return insertion_ ? insertion_->device().health() : std::nullopt;
}

haptics::LoopStatistics InsertionControl::halt()
{
  if (!insertion_) return {};
  wish_ = PendingRequest::rest;
  insertion_->stop();
  return insertion_->loop().statistics();
}

std::string InsertionControl::couplingText() const
{
  return insertion_ ? insertion_->couplingText() : std::string();
}

std::optional<std::filesystem::path> InsertionControl::recording() const
{
  return insertion_ && recordingError().empty() ? insertion_->recording() : std::nullopt;
}

std::optional<std::filesystem::path> InsertionControl::openRecording() const
{
  return progress() == Progress::concluded ? std::nullopt : recording();
}

Sentence InsertionControl::recordingError() const
{
  if (!recordingError_.empty() || !insertion_) return recordingError_;
  return insertion_->recordingError();
}

}  // namespace perilymph::gui
