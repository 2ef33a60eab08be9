// SPDX-License-Identifier: BSD-3-Clause
#include "SlidingHandle.h"

#include <algorithm>
#include <cmath>

namespace perilymph::hidstack {

void SlidingHandle::advanceTo(double time)
{
  // If the watchdog acts within a step, the step is divided there.
  const double expiry = lastCommand_ + body_.watchdog;
  if (force_ != 0.0 && time >= expiry) {
    slide(std::max(0.0, expiry - time_));
    time_ = std::max(time_, expiry);
    force_ = 0.0;
    hasTimedOut_ = true;
  }
  if (time <= time_) return;
  slide(time - time_);
  time_ = time;
}

void SlidingHandle::slide(double duration)
{
  if (isHeld_) return;
  // v(t) = w + (v - w) exp(-b t / m) with w = F / b; x its integral.
  const double terminal = (push_ + force_) / body_.damping;
  const double lag = body_.mass / body_.damping;
  const double faded = -std::expm1(-duration / lag);
  position_ += terminal * duration + (velocity_ - terminal) * lag * faded;
  velocity_ += (terminal - velocity_) * faded;
  if (std::abs(position_) < body_.reach) return;
  position_ = std::clamp(position_, -body_.reach, body_.reach);
  velocity_ = 0.0;
}

void SlidingHandle::hold(bool isHeld)
{
  isHeld_ = isHeld;
  velocity_ = 0.0;
}

void SlidingHandle::put(double position)
{
  position_ = position;
  velocity_ = 0.0;
}

void SlidingHandle::actuate(double force)
{
  force_ = force;
  lastCommand_ = time_;
  hasTimedOut_ = false;
}

}  // namespace perilymph::hidstack
