// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Rest.h"

#include <cmath>

namespace perilymph::haptics {

Rest::Rest(const RestLimits& limits, double timeStep)
    : limits_(limits), timeStep_(timeStep), isOn_(std::isfinite(limits.after))
{
}

bool Rest::isLeftBy(const device::DeviceSample& sample) const noexcept
{
  if ((sample.buttons & device::graspButton) == 0) return true;
  const Eigen::Vector3d at_D(sample.position_D[0], sample.position_D[1], sample.position_D[2]);
  return !((at_D - hand_D_).squaredNorm() <= handMotion * handMotion);  // also catches NaN
}

void Rest::end() noexcept
{
  if (isHeld_) ticksStill_ = 0;
  isOn_ = false;
}

void Rest::note(const Condition& now) noexcept
{
  const bool mayRest = now.mayRest && (!now.isHeld || limits_.motion > 0.0);
  const bool hasMoved =
      now.isHeld && !((now.tip_W - tip_W_).squaredNorm() <= limits_.motion * limits_.motion);
  ticksStill_ = mayRest && !hasMoved && now.isHeld == isHeld_ ? ticksStill_ + 1 : 0;
  if (ticksStill_ == 0) tip_W_ = now.tip_W;
  const double still = static_cast<double>(ticksStill_) * timeStep_;
  isOn_ = ticksStill_ > 0 && now.isSteady &&
          (now.hasBegun ? still >= limits_.after : std::isfinite(limits_.after) && !now.isHeld);
  isHeld_ = now.isHeld;
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
}

}  // namespace perilymph::haptics
