// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Rest.h"

#include <cmath>

namespace perilymph::haptics {

namespace {

/// False for a NaN.
bool isWithin(const Eigen::Vector3d& one, const Eigen::Vector3d& other, double distance)
{
  return (one - other).squaredNorm() <= distance * distance;
}

}  // namespace

Rest::Rest(const RestLimits& limits, double timeStep)
    : limits_(limits), timeStep_(timeStep), isOn_(std::isfinite(limits.after))
{
}

bool Rest::isLeftBy(const device::DeviceSample& sample) const noexcept
{
  if ((sample.buttons & device::graspButton) == 0) return true;
  const Eigen::Vector3d at_D(sample.position_D[0], sample.position_D[1], sample.position_D[2]);
  const double reach = isInserting_ ? limits_.handMotion : handMotionAtDepth;
  return !isWithin(at_D, hand_D_, reach);
}

void Rest::end() noexcept
{
  if (isHeld_) ticksStill_ = 0;
  isOn_ = false;
}

void Rest::note(const Condition& now) noexcept
{
  const bool mayRest = now.mayRest && (!now.isHeld || limits_.motion > 0.0) &&
                       (!now.isInserting || limits_.handMotion > 0.0);
  const bool hasMoved =
      (now.isHeld && !isWithin(now.tip_W, tip_W_, limits_.motion)) ||
      (now.isInserting && !isWithin(now.hand_D, movedHand_D_, limits_.handMotion));
  const bool isAsBefore = now.isHeld == isHeld_ && now.isInserting == isInserting_;
  ticksStill_ = mayRest && !hasMoved && isAsBefore ? ticksStill_ + 1 : 0;
  if (ticksStill_ == 0) {
    tip_W_ = now.tip_W;
    movedHand_D_ = now.hand_D;
  }
  const double still = static_cast<double>(ticksStill_) * timeStep_;
  isOn_ = ticksStill_ > 0 && now.isSteady &&
          (now.hasBegun ? still >= limits_.after : std::isfinite(limits_.after) && !now.isHeld);
  isHeld_ = now.isHeld;
  isInserting_ = now.isInserting;
  hand_D_ = now.hand_D;
}

void Rest::addTo(Hash& hash) const noexcept
{
  hash.add(isOn_);
  hash.add(ticksStill_);
  if (!(limits_.motion > 0.0)) return;
  hash.add(isHeld_);
  for (int i = 0; i < 3; ++i) {
    hash.add(tip_W_[i]);
    hash.add(hand_D_[i]);
  }
  if (!(limits_.handMotion > 0.0)) return;
  hash.add(isInserting_);
  for (int i = 0; i < 3; ++i) hash.add(movedHand_D_[i]);
}

}  // namespace perilymph::haptics
