// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Highlights.h"

#include <algorithm>

namespace perilymph::session {

void Highlights::add(const haptics::TickRecord& record) noexcept
{
  const haptics::TickOutput& now = record.output;
  ++ticks;
  // The tick of the arrival is no longer Inserting, but its motion still is of the hand.
  const bool hasMoved = isMoving || now.workflow == haptics::Workflow::inserting;
  isMoving = now.workflow == haptics::Workflow::inserting;
  if (!(now.time > 0.0)) return;
  hasBegun = true;
  if (hasMoved) duration = std::max(duration, now.time);
  deepest = std::max(deepest, now.depth);
  deepestAngle = std::max(deepestAngle, now.angularDepth);
  if (end == haptics::InsertionEnd::none || end == haptics::InsertionEnd::finished)
    if (const auto ended = haptics::endOf(now); ended != haptics::InsertionEnd::none) end = ended;
  if (!haptics::raisesPeak(now, peakForce)) return;
  peakForce = now.axialForce;
  peakTravel = now.travel;
  peakDepth = now.depth;
}

}  // namespace perilymph::session
