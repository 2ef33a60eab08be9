// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/StopForce.h"

#include <algorithm>

#include "perilymph/analysis/RunningMean.h"

namespace perilymph::analysis {

void StopForce::add(const haptics::TickOutput& now)
{
  // The tick of the arrival is no longer Inserting, but its motion still is of the hand.
  const bool isMotion =
      before_ && before_->workflow == haptics::Workflow::inserting && now.travel != before_->travel;
  if (isMotion) {
    inMotion_ += now.time - before_->time;
    last_.push_back({inMotion_, now.axialForce});
    while (last_.front().time <= inMotion_ - window_ + timeRounding) last_.pop_front();
  }
  before_ = now;
}

double StopForce::value() const
{
  if (last_.empty()) return 0.0;
  const auto count = static_cast<double>(last_.size());
  double time = 0.0, force = 0.0;
  double lowest = last_.front().force, highest = lowest;
  for (const Point& each : last_) {
    lowest = std::min(lowest, each.force);
    highest = std::max(highest, each.force);
    time += each.time / count;
    force += each.force / count;
  }
  double ofTime = 0.0, ofBoth = 0.0;
  for (const Point& each : last_) {
    ofTime += (each.time - time) * (each.time - time);
    ofBoth += (each.time - time) * (each.force - force);
  }
  const double slope = ofTime > 0.0 ? ofBoth / ofTime : 0.0;
  // no more than a force that was there: an end force above the peak would be none
  return std::clamp(force + slope * (last_.back().time - time), lowest, highest);
}

}  // namespace perilymph::analysis
