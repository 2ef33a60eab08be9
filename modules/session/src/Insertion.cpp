// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Insertion.h"

#include <algorithm>
#include <cmath>

#include "MakeEngine.h"
#include "perilymph/foundation/UtcTime.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/haptics/CouplingLimit.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/haptics/TickBound.h"
#include "recording/DeviceReport.h"
#include "recording/Recorder.h"

namespace perilymph::session {

namespace {

RecordingFacts factsOf(const InsertionParameters& parameters, const std::string& text,
                       const mechanics::InsertionModel& model, const device::DeviceTraits& traits,
                       const RunParameters& run)
{
  RecordingFacts facts;
  facts.scenarioName = parameters.name;
  facts.scenarioText = text;
  facts.device = traits.name;
  facts.timeStep = model.timeStep;
  facts.run = run;
  facts.deviceDelay = traits.transportDelay;
  facts.seed = parameters.seed;
  facts.modelFingerprint = model.fingerprint;
  facts.version = version();
  facts.buildId = buildId();
  facts.startedUtc = utcNow();
  return facts;
}

/// A device that renders force needs short time steps [s]: after a stop two of them remove the force.
constexpr double maxStepWithForce = 2e-3;

Error tooSlow(const device::DeviceTraits& traits, double timeStep)
{
  return Error{
      "dt_ms is %1; with %2, which renders force, it must be at most %3, so that a stop removes "
      "the force within 5 ms. Set dt_ms = 1.",
      std::to_string(timeStep * 1e3), traits.name, std::to_string(maxStepWithForce * 1e3)};
}

Error fault(const InsertionParameters& parameters, const haptics::TickRecord& record)
{
  return Error{
      "The insertion of %1 stopped with a fault at tick %2, %3 mm of travel (%4). Try a smaller "
      "dt_ms, a lower speed_mm_s or a softer wall.",
      parameters.name, record.tick, std::to_string(inMillimeters(meters(record.output.travel))),
      statusText(record.output.status)};
}

}  // namespace

struct Insertion::Content {
  InsertionParameters parameters;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::shared_ptr<const mechanics::InsertionModel> model;
  std::shared_ptr<device::HapticDevice> device;
  std::optional<std::filesystem::path> file;
  std::string couplingText;
  std::unique_ptr<haptics::HapticLoop> loop;
  std::unique_ptr<Recorder> recorder;
};

Insertion::Insertion() : content_(std::make_unique<Content>()) {}

Insertion::~Insertion()
{
  stop();
  // Stop the recorder first, because it reads losses from the loop; the loop then sets the force to
  // zero.
  content_->recorder.reset();
  content_->loop.reset();
  if (content_->device) content_->device->close();
}

Result<std::unique_ptr<Insertion>> Insertion::prepare(
    const Scenario& scenario, std::shared_ptr<device::HapticDevice> device,
    std::optional<std::filesystem::path> record,
    std::shared_ptr<const anatomy::ScalaTympani> anatomy,
    std::shared_ptr<const mechanics::InsertionModel> model)
{
  return prepare(scenario.parameters(), scenario.text(), std::move(device), std::move(record),
                 std::move(anatomy), std::move(model));
}

Result<std::unique_ptr<Insertion>> Insertion::prepare(
    const InsertionParameters& parameters, std::shared_ptr<device::HapticDevice> device,
    std::shared_ptr<const anatomy::ScalaTympani> anatomy,
    std::shared_ptr<const mechanics::InsertionModel> model)
{
  return prepare(parameters, {}, std::move(device), std::nullopt, std::move(anatomy),
                 std::move(model));
}

Result<std::unique_ptr<Insertion>> Insertion::prepare(
    const InsertionParameters& parameters, const std::string& text,
    std::shared_ptr<device::HapticDevice> device, std::optional<std::filesystem::path> record,
    std::shared_ptr<const anatomy::ScalaTympani> anatomy,
    std::shared_ptr<const mechanics::InsertionModel> model)
{
  if (!anatomy) {
    auto built = buildAnatomy(parameters);
    if (!built) return built.error();
    anatomy = *built;
  }
  if (!model) {
    auto built = buildModel(parameters, anatomy);
    if (!built) return built.error();
    model = *built;
  }
  if (const auto done = device->open(); !done) return done.error();

  std::unique_ptr<Insertion> insertion(new Insertion);
  Content& content = *insertion->content_;
  content.parameters = parameters;
  content.anatomy = std::move(anatomy);
  content.model = std::move(model);
  content.device = std::move(device);
  content.file = std::move(record);

  const device::DeviceTraits traits = content.device->traits();
  if (traits.rendersForce && content.model->timeStep > maxStepWithForce)
    return tooSlow(traits, content.model->timeStep);
  const RunParameters run =
      runParameters(parameters.engine.safety, traits, content.model->timeStep);
  if (traits.rendersForce)
    content.couplingText = haptics::couplingSentence(
        parameters.engine.forceScale * parameters.engine.motionScale *
            parameters.engine.couplingStiffness,
        haptics::couplingLimit(traits, content.model->timeStep), traits.name);

  auto engine = makeEngine(parameters, content.model, run);
  if (!engine) return engine.error();
  std::unique_ptr<Recording> recording;
  if (content.file) {
    auto created =
        Recording::create(*content.file, factsOf(parameters, text, *content.model, traits, run));
    if (!created) return created.error();
    recording = std::move(*created);
  }
  content.loop = std::make_unique<haptics::HapticLoop>(*content.device, std::move(*engine));
  content.recorder =
      std::make_unique<Recorder>(*content.loop, std::move(recording), content.model->timeStep);
  return insertion;
}

Result<void> Insertion::runToEnd(const std::function<bool(const haptics::TickRecord&)>& each,
                                 std::uint64_t maxTicks)
{
  Content& content = *content_;
  const auto send = [&](haptics::Command::Kind kind) {
    haptics::Command command;
    command.kind = kind;
    return content.loop->send(command);
  };
  if (content.loop->engine().workflow() == haptics::Workflow::idle &&
      !send(haptics::Command::Kind::arm))
    return Error{"The loop takes no requests: eight are waiting. Run a tick first."};
  content.device->move(device::ScriptedMotion::insert);

  bool isWithdrawing = false;
  for (std::uint64_t i = 0; i < maxTicks; ++i) {
    content.loop->runOnce();
    haptics::TickRecord record;
    if (!content.loop->take(record)) continue;
    content.recorder->keep(record);
    if (each && !each(record)) break;

    const haptics::Workflow workflow = record.output.workflow;
    if (workflow == haptics::Workflow::fault) {
      content.recorder->flush();
      return fault(content.parameters, record);
    }
    if (workflow != haptics::Workflow::finished) continue;
    const bool hasArrived = haptics::endOf(record.output) == haptics::InsertionEnd::finished;
    if (!content.parameters.withdraws || isWithdrawing || !hasArrived) break;
    isWithdrawing = send(haptics::Command::Kind::withdraw);
    content.device->move(device::ScriptedMotion::withdraw);
  }
  content.recorder->flush();
  return {};
}

std::uint64_t maxTicks(const InsertionParameters& parameters,
                       const mechanics::InsertionModel& model) noexcept
{
  const double way = model.parts.array.length.si() * (parameters.withdraws ? 2.0 : 1.0);
  const double time = 2.0 * way / parameters.speed.si() + 1.0;
  return static_cast<std::uint64_t>(std::ceil(time / model.timeStep));
}

Result<void> Insertion::start()
{
  // Late ticks of a device that renders force can be felt; those of a mouse or a script cannot.
  if (content_->device->traits().rendersForce)
    if (auto bounded = haptics::checkTickBound(*content_->model); !bounded) return bounded;
  // Start the recorder first: its thread must run before the channel fills.
  content_->recorder->start();
  content_->loop->start();
  return {};
}

Sentence Insertion::memoryNote() const { return noteOn(content_->loop->lockedMemory()); }

void Insertion::stop() noexcept
{
  if (content_->loop) content_->loop->stop();
  if (content_->recorder && content_->loop) {
    const auto health = content_->device->health();
    if (health)
      content_->recorder->describeDevice(deviceReport(*health, content_->loop->statistics()));
  }
  if (content_->recorder) content_->recorder->stop();
}

bool Insertion::send(const haptics::Command& command) noexcept
{
  return content_->loop->send(command);
}

void Insertion::requestStop() noexcept { content_->loop->requestStop(); }

void Insertion::requestStopAt(std::int64_t time) noexcept { content_->loop->requestStopAt(time); }

void Insertion::cancelStopAt() noexcept { content_->loop->cancelStopAt(); }

bool Insertion::refresh() noexcept { return content_->loop->refresh(); }

const haptics::Snapshot& Insertion::latest() const noexcept { return content_->loop->latest(); }

Sentence Insertion::recordingError() const { return content_->recorder->error(); }

void Insertion::concludeRecording() noexcept { content_->recorder->conclude(latest().lostRecords); }

bool Insertion::isRecordingConcluded() const noexcept { return content_->recorder->isConcluded(); }

Result<void> Insertion::closeRecording()
{
  content_->recorder->close();
  const Sentence error = recordingError();
  if (!error.empty()) return Error{error};
  return {};
}

const InsertionParameters& Insertion::parameters() const noexcept { return content_->parameters; }

const anatomy::ScalaTympani& Insertion::anatomy() const noexcept { return *content_->anatomy; }

std::shared_ptr<const anatomy::ScalaTympani> Insertion::sharedAnatomy() const noexcept
{
  return content_->anatomy;
}

const mechanics::InsertionModel& Insertion::model() const noexcept { return *content_->model; }

const std::string& Insertion::couplingText() const noexcept { return content_->couplingText; }

std::shared_ptr<const mechanics::InsertionModel> Insertion::sharedModel() const noexcept
{
  return content_->model;
}

device::HapticDevice& Insertion::device() noexcept { return *content_->device; }

const haptics::HapticLoop& Insertion::loop() const noexcept { return *content_->loop; }

const std::optional<std::filesystem::path>& Insertion::recording() const noexcept
{
  return content_->file;
}

}  // namespace perilymph::session
