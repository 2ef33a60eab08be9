// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/MotionCounter.h"

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
    ++reversals_;
  }
}

void MotionCounter::add(const haptics::TickOutput& now)
{
  // Idle: the array was reset to its start, which is not motion of the hand.
  if (now.workflow == haptics::Workflow::idle) return begin_.reset();
  reversals_.add(now.travel);
  if (!begin_) {
    begin_ = now;
    return;
  }
  if (now.time - begin_->time >= stretch * (1.0 - slack)) endStretch(now);
}

void MotionCounter::endStretch(const haptics::TickOutput& now)
{
  const double time = now.time - begin_->time;
  const double way = now.travel - begin_->travel;
  const double speed = way / time;
  begin_ = now;
  const bool isStill = std::fabs(speed) < slowestSpeed.si() * (1.0 - slack);
  if (!hasMoved_ && isStill) return;  // waiting for the start is not a stop
  hasMoved_ = true;
  sofar_.time += time;
  if (isStill) sofar_.timeStill += time;
  if (way > 0.0) {
    sofar_.wayIn += way;
    if (!isStill && speed <= fastestSpeed.si() * (1.0 + slack)) sofar_.wayInBand += way;
  }
  sofar_.reversals = reversals_.reversals();
  if (!(now.travel > deepest_)) return;
  deepest_ = now.travel;
  untilDeepest_ = sofar_;
}

}  // namespace perilymph::analysis
