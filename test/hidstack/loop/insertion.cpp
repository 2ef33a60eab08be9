// SPDX-License-Identifier: BSD-3-Clause
#include "insertion.h"

#include <poll.h>

#include <csignal>
#include <memory>

#include "FlatWallScene.h"
#include "HandleScript.h"
#include "TimedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/realtime/Pacer.h"

namespace perilymph::hidstack {

namespace {

using haptics::Command;

constexpr std::size_t maxTicks = 30'000;  // half a minute at 1 kHz
constexpr int glance_ms = 20;  // of the user of the insertion; a recorder drains as often
// After the last disconnection: long enough to observe the loop.
constexpr int ticksAfterwards = 200;

/// Sleeps until the clock is at a phase of a device's period that is another one for each `index`.
void awaitPhase(int index)
{
  constexpr std::int64_t period = 1'000'000;  // of the virtual handle [ns]
  const std::int64_t now = realtime::monotonicNanoseconds();
  const std::int64_t due = (now / period + 1) * period + index % startPhases * period / startPhases;
  realtime::Pacer pacer(Duration::fromSi(1e-9 * static_cast<double>(period)));
  pacer.start(due - period);
  pacer.wait();
}

/// Simulates the user: arms the insertion, and begins another one after a fault when the device
/// responds again.
class Operator {
public:
  explicit Operator(device::HapticDevice& hand) : hand_(hand) { begin(); }

  haptics::HapticLoop& loop() { return *loop_; }

  void watch(const haptics::TickRecord& record)
  {
    ++ticksSinceUnplug_;
    const bool isLost = (record.output.status & haptics::deviceLost) != 0;
    if (isLost && !wasLost_) {
      ++unplugs_;
      ticksSinceUnplug_ = 0;
    }
    wasLost_ = isLost;
    isOver_ = record.output.workflow == haptics::Workflow::fault && !isLost;
  }
  void beginAgainAfterFault()
  {
    if (isOver_) begin();
  }

  bool isDone(int unplugs) const
  {
    return unplugs_ >= unplugs && ticksSinceUnplug_ >= ticksAfterwards;
  }

private:
  void begin()
  {
    isOver_ = false;
    loop_.reset();
    loop_ =
        std::make_unique<haptics::HapticLoop>(hand_, flatWallEngine(hand_.traits().nominalPeriod));
    loop_->send({Command::Kind::arm});
    awaitPhase(begun_++);
    loop_->start();
  }

  device::HapticDevice& hand_;
  std::unique_ptr<haptics::HapticLoop> loop_;
  bool wasLost_ = false;
  bool isOver_ = false;
  int begun_ = 0;
  int unplugs_ = 0;
  int ticksSinceUnplug_ = 0;
};

}  // namespace

Result<std::vector<LoopTick>> insertUntilUnplugged(device::HapticDevice& hand, int unplugs)
{
  TimedDevice timed(hand, maxTicks);
  Operator user(timed);
  haptics::TickRecord record;
  for (std::size_t ticks = 0; !user.isDone(unplugs);) {
    ::poll(nullptr, 0, glance_ms);
    for (; user.loop().take(record); ++ticks) user.watch(record);
    user.beginAgainAfterFault();
    if (ticks > maxTicks)
      return Error{"The device was not unplugged " + std::to_string(unplugs) + " times within " +
                   std::to_string(ticks) + " ticks; see what the handle's script says."};
  }
  user.loop().stop();
  return timed.ticks();
}

Result<void> insertUntilKilled(device::HapticDevice& hand, std::size_t ticks)
{
  Operator user(hand);
  haptics::TickRecord record;
  for (std::size_t done = 0; done < ticks;) {
    ::poll(nullptr, 0, glance_ms);
    for (; user.loop().take(record); ++done) user.watch(record);
  }
  std::raise(SIGKILL);
  return {};
}

}  // namespace perilymph::hidstack
