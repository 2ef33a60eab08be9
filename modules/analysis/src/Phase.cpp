// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Phase.h"

#include "perilymph/haptics/InsertionEnd.h"

namespace perilymph::analysis {

namespace {

constexpr Length startTolerance = millimeters(0.05);  // shown as 0.0 mm

}  // namespace

Phase phaseOf(const haptics::TickOutput& now, Length stopTravel) noexcept
{
  // A finished withdrawal ends near the start: only the depth distinguishes it from a finished
  // insertion. One that buckled, jammed or met too much resistance has not arrived.
  const bool isFinished =
      now.workflow == haptics::Workflow::finished && (now.status & haptics::anyEnd) == 0;
  const bool hasArrived =
      now.travel >= stopTravel.si() || (isFinished && now.travel > 0.5 * stopTravel.si());
  if (hasArrived) return Phase::full;
  if (now.depth <= 0.0) return Phase::outside;
  // Back at the start, a curved array may still touch the wall behind the opening.
  if (now.travel < startTolerance.si()) return Phase::opening;
  if (now.angularDepth >= basalTurnAngle.si()) return Phase::basalTurn;
  if (now.contacts > 0 && now.angularDepth > 0.0) return Phase::outerWall;
  return Phase::opening;
}

const char* phaseName(Phase phase) noexcept
{
  switch (phase) {
    case Phase::outside:
      return "outside";
    case Phase::opening:
      return "opening";
    case Phase::outerWall:
      return "outer wall";
    case Phase::basalTurn:
      return "basal turn";
    case Phase::full:
      return "full";
  }
  return "unknown";
}

}  // namespace perilymph::analysis
