// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Motion of the stylet relative to the array.

#include <optional>

#include "perilymph/foundation/Hash.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::haptics {

/// Withdrawal of the stylet: pulled at a constant speed toward a target, or held still while the
/// array advances. It is never pushed back into the array.
class StyletMotion {
public:
  /// @param speed      While it is pulled [m/s].
  /// @param holdDepth  Depth of its tip past the opening from which it is held still [m].
  StyletMotion(double speed, std::optional<double> holdDepth) noexcept
      : speed_(speed), holdDepth_(holdDepth)
  {
  }

  /// Sets the target [m]; an earlier one is only raised.
  void pullTo(const mechanics::InsertionModel& model, double target) noexcept;
  /// Keeps it where it is.
  void stop() noexcept { target_ = withdrawal_; }
  /// One time step, with the depth of the array's tip [m].
  void step(const mechanics::InsertionModel& model, double depth) noexcept;

  double withdrawal() const noexcept { return withdrawal_; }  ///< [m]
  bool isAtRest() const noexcept { return withdrawal_ >= target_; }
  /// Adds all data that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  double speed_;
  std::optional<double> holdDepth_;
  double target_ = 0.0;      // [m]
  double withdrawal_ = 0.0;  // [m]
};

}  // namespace perilymph::haptics
