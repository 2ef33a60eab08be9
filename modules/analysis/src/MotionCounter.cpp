// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/MotionCounter.h"

#include <algorithm>
#include <cmath>

namespace perilymph::analysis {

namespace {

constexpr double stretch = 0.05;  // [s]; the period of the published experiment's samples

// Tolerance for rounding errors of speeds at the limits of the range.
constexpr double slack = 1e-3;

}  // namespace

void ReversalCounter::add(double travel)
{
  constexpr double trembling = 1e-4;  // [m]
  if (!hasBegun_) {
    hasBegun_ = true;
    extreme_ = travel;
    return;
  }
  const double way = travel - extreme_;
  if (direction_ == 0) {
    if (std::fabs(way) >= trembling) {
      direction_ = way > 0.0 ? 1 : -1;
      extreme_ = travel;
    }
  } else if (way * direction_ > 0.0) {
    extreme_ = travel;
  } else if (std::fabs(way) >= trembling) {
    direction_ = -direction_;
    extreme_ = travel;
    if (direction_ < 0) ++reversals_;
  }
}

void MotionCounter::add(const haptics::TickOutput& now)
{
  // Idle: the array was reset to its start, which is not motion of the hand.
  if (now.workflow == haptics::Workflow::idle) return begin_.reset();
  reversals_.add(now.travel);
  if (!first_) first_ = now;
  // Finished: waiting at full depth is no hesitation.
  if (now.workflow == haptics::Workflow::finished) return begin_.reset();
  // Where the hand grasps or releases, its position is another one without motion.
  if (!begin_ || begin_->workflow != now.workflow) {
    begin_ = now;
    return;
  }
  if (now.time - begin_->time >= stretch * (1.0 - slack)) endStretch(now);
}

/// Motion of the hand since the begin of the interval along the base's path [m], positive inward.
double MotionCounter::wayOfHand(const haptics::TickOutput& now) const
{
  constexpr double known = 2e-4;  // [m]; from here on the direction of the path is known
  double squared = 0.0, pathSquared = 0.0, along = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double moved = now.device_W[i] - begin_->device_W[i];
    const double path = now.proxy_W[i] - first_->proxy_W[i];
    squared += moved * moved;
    pathSquared += path * path;
    along += moved * path;
  }
  if (pathSquared >= known * known) return along / std::sqrt(pathSquared);
  return std::copysign(std::sqrt(squared), now.travel - begin_->travel);
}

void MotionCounter::endStretch(const haptics::TickOutput& now)
{
  const double time = now.time - begin_->time;
  const double way = now.travel - begin_->travel;
  const double speed = wayOfHand(now) / time;
  begin_ = now;
  const bool isStill = std::fabs(speed) < slowestSpeed.si() * (1.0 - slack);
  if (!hasMoved_ && isStill) return;  // waiting for the start is not a stop
  hasMoved_ = true;
  sofar_.time += time;
  if (isStill) sofar_.timeStill += time;
  if (way > 0.0) {
    sofar_.wayIn += way;
    const double size = std::fabs(speed);
    const bool isInBand = !isStill && size <= fastestSpeed.si() * (1.0 + slack);
    if (isInBand) sofar_.wayInBand += way;
    const double part = isStill ? size / slowestSpeed.si() : fastestSpeed.si() / size;
    sofar_.wayBySpeed += way * (isInBand ? 1.0 : std::min(part, 1.0));
  }
  sofar_.reversals = reversals_.reversals();
  if (!(now.travel > deepest_)) return;
  deepest_ = now.travel;
  untilDeepest_ = sofar_;
}

}  // namespace perilymph::analysis
