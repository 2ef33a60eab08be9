// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/VisitorSession.h"

#include <algorithm>

namespace perilymph::gui {

namespace {

/// Smaller returns are tremor, not reversals.
constexpr double reversalTravel_m = 0.3e-3;

}  // namespace

void VisitorSession::follow(const haptics::Snapshot& snapshot)
{
  const haptics::TickOutput& now = snapshot.output;
  if (now.workflow == haptics::Workflow::idle || now.workflow == haptics::Workflow::armed) return;
  profiler_.add({snapshot.tick, {}, {}, now});
  peakForce_ = snapshot.peak.force;
  deepestTravel_ = std::max(deepestTravel_, now.travel);
  deepest_ = std::max(deepest_, now.depth);
  duration_ = now.time;
  turning_ = isAdvancing_ ? std::max(turning_, now.travel) : std::min(turning_, now.travel);
  if (isAdvancing_ && now.travel < turning_ - reversalTravel_m) {
    ++reversals_;
    isAdvancing_ = false;
    turning_ = now.travel;
  } else if (!isAdvancing_ && now.travel > turning_ + reversalTravel_m) {
    isAdvancing_ = true;
    turning_ = now.travel;
  }
}

}  // namespace perilymph::gui
