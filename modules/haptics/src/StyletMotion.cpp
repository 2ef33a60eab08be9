// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/StyletMotion.h"

#include <algorithm>

namespace perilymph::haptics {

void StyletMotion::pullTo(const mechanics::InsertionModel& model, double target) noexcept
{
  target_ = std::clamp(target, withdrawal_, std::max(withdrawal_, model.parts.array.length.si()));
}

void StyletMotion::step(const mechanics::InsertionModel& model, double depth) noexcept
{
  withdrawal_ = std::min(target_, withdrawal_ + speed_ * model.timeStep);
  if (!holdDepth_ || model.styletBending <= 0.0) return;
  // The stylet is held in the cochlea: the array's further advance withdraws it relatively. When
  // the array is withdrawn, it takes the stylet along.
  const double held = depth - model.styletFromTip - *holdDepth_;
  withdrawal_ = std::clamp(held, withdrawal_, std::max(withdrawal_, model.parts.array.length.si()));
  target_ = std::max(target_, withdrawal_);
}

void StyletMotion::addTo(Hash& hash) const noexcept
{
  hash.add(target_);
  hash.add(withdrawal_);
}

}  // namespace perilymph::haptics
