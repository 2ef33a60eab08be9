// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Detection of the round window in a fitted cochlea: the hole in the bone at the basal end of the
// outer wall.

#include <optional>

#include "ImageFit.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// The round window's center on the outer wall.
struct RoundWindow {
  Eigen::Vector3d center_W;
  double angle = 0.0;       ///< In W [rad].
  double angleError = 0.0;  ///< Standard deviation [rad].
  bool isFound = false;     ///< False: no opening where it usually is; from one farther along the
                            ///< wall, or from the spiral only.
};

/// Searches outward from the lumen for bone. The window's opening is where no ray meets bone; its
/// center is that of the opening, and its distance from the axis that of the bony rim, by a plane.
RoundWindow findRoundWindow(const CtVolume& volume, const ShapedLumen& lumen,
                            const FitState& state);

/// The window with a click on its center as an additional observation, with a precision of 0.5 mm.
RoundWindow withClick(const RoundWindow& window, const Eigen::Vector3d& click_W);

}  // namespace perilymph::ct
