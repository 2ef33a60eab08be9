// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/HapticLoop.h"

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>

#include "perilymph/foundation/RealTime.h"
#include "perilymph/haptics/CouplingLimit.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/realtime/RealTimePriority.h"
#include "perilymph/realtime/SpscRing.h"
#include "perilymph/realtime/TimeHistogram.h"
#include "perilymph/realtime/TripleBuffer.h"

namespace perilymph::haptics {

namespace {

// Eight seconds at 1 kHz: a recorder that waits for a slow disk loses no record.
constexpr std::size_t recordsKept = 8192;
constexpr std::int64_t second = 1'000'000'000;  // [ns]
constexpr std::int64_t atOnce = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

std::unique_ptr<InsertionEngine> checked(std::unique_ptr<InsertionEngine> engine)
{
  if (!engine) throw std::invalid_argument("A haptic loop needs an engine; it was given none.");
  return engine;
}

}  // namespace

struct HapticLoop::Content {
  Content(device::HapticDevice& openDevice, std::unique_ptr<InsertionEngine> checkedEngine)
      : device(openDevice),
        engine(std::move(checkedEngine)),
        pacer(Duration::fromSi(engine->model().timeStep)),
        period(std::llround(engine->model().timeStep * 1e9))
  {
    const device::DeviceTraits traits = device.traits();
    if (traits.rendersForce) engine->lowerMaxForce(traits.maxForce);
  }

  CommandList takeCommands() noexcept;
  void noteSilence() noexcept;
  bool takeStop() noexcept;
  std::int64_t waitForTick() noexcept;
  void publish() noexcept;
  void measure(std::int64_t began, std::int64_t ended) noexcept;

  device::HapticDevice& device;
  std::unique_ptr<InsertionEngine> engine;

  realtime::TripleBuffer<Snapshot> snapshots;
  realtime::SpscRing<TickRecord> records{recordsKept};
  realtime::SpscRing<Command> commands{maxCommandsPerTick};
  std::thread thread;
  std::atomic<bool> isStopping{false};
  std::atomic<std::int64_t> stopAt{never};  // when to stop the insertion [ns]

  // Written by the haptic thread; others read it after the thread has ended.
  realtime::Pacer pacer;
  std::int64_t period;            // [ns]
  bool followsDevice = false;     // reports may trigger ticks
  bool isHandFresh = false;       // the last tick had a fresh sample
  std::uint64_t sequence = 0;     // of that sample
  std::uint64_t ticksSilent = 0;  // without a fresh sample, while the hand holds on at rest
  std::int64_t lastBegan = 0;     // [ns]
  std::uint64_t ticks = 0;
  std::uint64_t recordedTicks = 0;
  std::uint64_t overruns = 0;
  std::uint64_t lostRecords = 0;
  realtime::TimeHistogram allTicks;
  realtime::TimeHistogram ticksOfSecond;
  std::int64_t secondBegan = 0;  // [ns]
  double measuredRate = 0.0;     // [1/s]
  double tickTimeP99 = 0.0;      // [s]
  bool hasRealTimePriority = false;
  realtime::LockedMemory memory;  // by start()
  bool isStackLocked = false;
};

HapticLoop::HapticLoop(device::HapticDevice& device, std::unique_ptr<InsertionEngine> engine)
    : content_(std::make_unique<Content>(device, checked(std::move(engine))))
{
  content_->publish();
}

HapticLoop::~HapticLoop() { stop(); }

CommandList HapticLoop::Content::takeCommands() noexcept
{
  CommandList list;
  if (takeStop()) {
    // Commands sent before the stop are no longer wanted.
    Command discarded;
    for (int i = 0; i < maxCommandsPerTick && commands.take(discarded); ++i) {
    }
    list.items[0].kind = Command::Kind::stop;
    list.count = 1;
    return list;
  }
  while (list.count < maxCommandsPerTick && commands.take(list.items[list.count])) ++list.count;
  // A device that falls silent is stale, at rest, too: an empty command ends the rest, and the
  // recording contains it.
  const EngineSettings& settings = engine->settings();
  const double silent = static_cast<double>(ticksSilent) * engine->model().timeStep;
  if (list.count == 0 && silent >= SampleValidator::staleTime(settings.samplePeriod)) {
    list.items[0] = {};
    list.count = 1;
  }
  return list;
}

void HapticLoop::Content::noteSilence() noexcept
{
  ticksSilent = engine->isHeldAtRest() && !isHandFresh ? ticksSilent + 1 : 0;
}

bool HapticLoop::Content::takeStop() noexcept
{
  if (stopAt > lastBegan) return false;
  stopAt = never;
  return true;
}

void HapticLoop::Content::publish() noexcept
{
  Snapshot& snapshot = snapshots.draft();
  engine->fill(snapshot);
  snapshot.measuredRate = measuredRate;
  snapshot.lateTicks = pacer.lateTicks();
  snapshot.overruns = overruns;
  snapshot.tickTimeP99 = tickTimeP99;
  snapshot.lostRecords = lostRecords;
  snapshots.publishDraft();
}

void HapticLoop::runOnce() noexcept
{
  PERILYMPH_EXPECTS_ROLE(haptic);
  Content& loop = *content_;
  TickRecord record;
  record.tick = loop.recordedTicks;
  ++loop.ticks;
  record.commands = loop.takeCommands();

  record.sample = loop.device.read();
  loop.isHandFresh = record.sample.isValid != 0 && record.sample.sequence != loop.sequence;
  loop.sequence = record.sample.sequence;
  record.output = loop.engine->tick(record.sample, record.commands);
  loop.device.write(record.output.wrench_D);
  loop.noteSilence();

  loop.publish();  // for display: only the newest matters
  if ((record.output.status & resting) != 0) return;
  ++loop.recordedTicks;
  if (!loop.records.push(record)) ++loop.lostRecords;  // for the file: complete, or counted as lost
}

void HapticLoop::start()
{
  if (content_->thread.joinable()) return;
  content_->engine->model().prepareForRealTime();
  content_->isStopping = false;
  // What the tick writes at fixed places; the vectors of the state were written when it was built.
  const auto bytesOf = [](const auto& object) { return std::as_bytes(std::span(&object, 1)); };
  const std::array<std::span<const std::byte>, 4> buffers{
      bytesOf(*content_), bytesOf(*content_->engine), content_->commands.memory(),
      content_->records.memory()};
  content_->memory = realtime::lockMemory(buffers);
  content_->thread = std::thread([this] {
    declareThread(ThreadRole::haptic);
    Content& loop = *content_;
    loop.hasRealTimePriority =
        realtime::requestRealTimePriority() == realtime::RealTimePriority::granted;
    loop.isStackLocked = realtime::lockStack();
    const std::int64_t now = realtime::monotonicNanoseconds();
    loop.followsDevice = followsReports(loop.device.traits(), loop.engine->model().timeStep);
    loop.pacer.start(now);
    loop.secondBegan = now;
    loop.ticksOfSecond.clear();
    while (!loop.isStopping) {
      const std::int64_t began = loop.waitForTick();
      runOnce();
      loop.measure(began, realtime::monotonicNanoseconds());
    }
    // Here, because the thread that waits for this one may get a processor late.
    loop.device.write(device::Wrench{});
  });
}

/// Returns the time at which the next tick begins [ns].
std::int64_t HapticLoop::Content::waitForTick() noexcept
{
  auto awaited = device::Awaited::cannot;
  // Wait only for a device that is on time; a stalled one must not delay the ticks.
  if (followsDevice && isHandFresh)
    awaited = device.await(Duration::fromSi(engine->model().timeStep));
  const std::int64_t now = realtime::monotonicNanoseconds();

  // A report that arrives right after a tick by the clock waits half a period at most. If it waited
  // for the clock, so would every report after it: the force would stay late by up to a period.
  const bool isTooSoon = awaited == device::Awaited::fresh && now - lastBegan < period / 2;
  if (isTooSoon) pacer.start(lastBegan + period / 2 - period);
  if (awaited == device::Awaited::cannot || isTooSoon) {
    lastBegan = pacer.wait();
    return lastBegan;
  }
  pacer.follow(now);
  lastBegan = now;
  return now;
}

void HapticLoop::stop() noexcept
{
  if (!content_) return;
  if (content_->thread.joinable()) {
    content_->isStopping = true;
    content_->thread.join();
  }
  content_->device.write(device::Wrench{});
}

void HapticLoop::Content::measure(std::int64_t began, std::int64_t ended) noexcept
{
  const std::int64_t took = ended - began;
  allTicks.add(took);
  ticksOfSecond.add(took);
  if (took > period) ++overruns;
  const std::int64_t passed = ended - secondBegan;
  if (passed < second) return;
  measuredRate = static_cast<double>(ticksOfSecond.count()) / (static_cast<double>(passed) * 1e-9);
  tickTimeP99 = ticksOfSecond.quantile(0.99);
  ticksOfSecond.clear();
  secondBegan = ended;
}

const realtime::LockedMemory& HapticLoop::lockedMemory() const noexcept { return content_->memory; }

bool HapticLoop::send(const Command& command) noexcept { return content_->commands.push(command); }

void HapticLoop::requestStop() noexcept { content_->stopAt = atOnce; }

void HapticLoop::requestStopAt(std::int64_t time) noexcept
{
  std::int64_t current = content_->stopAt;
  while (time < current && !content_->stopAt.compare_exchange_weak(current, time)) {
  }
}

void HapticLoop::cancelStopAt() noexcept
{
  std::int64_t current = content_->stopAt;
  while (current != atOnce && !content_->stopAt.compare_exchange_weak(current, never)) {
  }
}

bool HapticLoop::refresh() noexcept { return content_->snapshots.refresh(); }

const Snapshot& HapticLoop::latest() const noexcept { return content_->snapshots.latest(); }

bool HapticLoop::take(TickRecord& record) noexcept { return content_->records.take(record); }

LoopStatistics HapticLoop::statistics() const
{
  const Content& loop = *content_;
  LoopStatistics statistics;
  statistics.ticks = loop.ticks;
  statistics.lateTicks = loop.pacer.lateTicks();
  statistics.missedTicks = loop.pacer.missedTicks();
  statistics.overruns = loop.overruns;
  statistics.lostRecords = loop.lostRecords;
  statistics.tickTimeMedian = loop.allTicks.quantile(0.5);
  statistics.tickTimeP99 = loop.allTicks.quantile(0.99);
  statistics.tickTimeMax = loop.allTicks.longest();
  statistics.hasRealTimePriority = loop.hasRealTimePriority;
  statistics.isMemoryLocked = loop.memory.isComplete() && loop.isStackLocked;
  return statistics;
}

const InsertionEngine& HapticLoop::engine() const noexcept { return *content_->engine; }

}  // namespace perilymph::haptics
