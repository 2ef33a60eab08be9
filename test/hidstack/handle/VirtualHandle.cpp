// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualHandle.h"

#include <cmath>
#include <utility>

namespace perilymph::hidstack {

namespace {

// The longest script, with a margin.
constexpr std::size_t maxTicks = 30'000;
// Index of the tick whose report is lost or repeated by the flawed scripts.
constexpr std::size_t flawedTick = 400;
constexpr std::uint8_t graspBit = 1;

double seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

}  // namespace

VirtualHandle::VirtualHandle(HandleScript script, const HandleBody& body)
    : script_(std::move(script)), slider_(body), ticks_(maxTicks)
{
  // Touch every page in advance: recording a tick then causes no page fault.
  ticks_.clear();
}

void VirtualHandle::begin(std::size_t index, std::int64_t now)
{
  const bool wasUnplugged = hasBegun_ && wire() == Wire::unplugged;
  passage_ = index;
  started_ = now;
  hasBegun_ = true;
  if (wire() == Wire::unplugged) slider_.actuate(0.0);
  if (wasUnplugged) {
    isHeard_ = false;
    slider_.put(0.0);
  }
  slider_.hold(passage().grip == Grip::held);
  slider_.push(passage().push);
}

bool VirtualHandle::tick(std::int64_t due)
{
  if (ticks_.size() == maxTicks) return false;
  slider_.advanceTo(seconds(due));
  if (!hasBegun_) begin(0, due);
  const bool isOver =
      passage().duration > 0.0 ? seconds(due - started_) >= passage().duration : isHeard_;
  if (isOver) {
    if (passage_ + 1 == script_.passages.size()) return false;
    begin(passage_ + 1, due);
  }

  HandleTick tick;
  tick.due = due;
  // A lost report is counted, unless the device pauses.
  if (wire() != Wire::paused && wire() != Wire::answering) ++sequence_;
  tick.sequence = sequence_;
  tick.position = slider_.position();
  tick.passage = passage().name;
  ticks_.push_back(tick);
  return true;
}

Wire VirtualHandle::wire() const { return passage().wire; }

int VirtualHandle::reportsDue() const
{
  if (wire() != Wire::reporting) return 0;
  if (ticks_.size() != flawedTick) return 1;
  if (script_.flaw == Flaw::lostReport) return 0;
  return script_.flaw == Flaw::repeatedReport ? 2 : 1;
}

std::array<std::uint8_t, inputSize> VirtualHandle::report() const
{
  InputReport report;
  report.sequence = sequence_;
  // Toward the cochlea is away from the user.
  report.place[2] = static_cast<std::int32_t>(-std::llround(slider_.position() / placeQuantum));
  report.buttons = passage().isButtonPressed ? graspBit : 0;
  return encode(report);
}

std::array<std::uint8_t, inputSize> VirtualHandle::answer()
{
  ++sequence_;
  return report();
}

void VirtualHandle::noteSent(std::int64_t now) { ticks_.back().sent = now; }

void VirtualHandle::take(const OutputReport& report, std::int64_t now)
{
  isHeard_ = true;
  double factor = -forceQuantum;  // positive z is away from the cochlea
  if (script_.flaw == Flaw::flippedForce) factor = -factor;
  if (script_.flaw == Flaw::doubledForce) factor *= 2.0;
  slider_.advanceTo(seconds(now));
  slider_.actuate(factor * report.force[2]);

  if (ticks_.empty()) return;
  HandleTick& tick = ticks_.back();
  if (tick.outputs++ > 0) return;
  tick.answered = now;
  tick.force = report.force[2];
}

}  // namespace perilymph::hidstack
