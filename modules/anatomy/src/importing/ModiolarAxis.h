// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Estimation of the modiolar axis.

#include <optional>
#include <vector>

#include "importing/AxialSections.h"

namespace perilymph::anatomy {

/// The axis of the spiral motion (simultaneous rotation, translation and scaling) that best maps a
/// surface onto itself: the area-weighted mean square of n . (v + c x p + g p) at the points p with
/// normal n is minimal (kinematic surface fitting). Oriented so that the surface shrinks with
/// increasing angle, toward the apex. Empty if no motion maps the surface onto itself.
std::optional<AxisFrame> spiralAxis(const Surface& closed);

/// An axis refined by the duct's center line: the one about which log r and z of the center line
/// are best fitted by polynomials of fourth degree in the angle. An axis error adds waves with a
/// period of one turn to both, which such polynomials cannot represent.
///
/// @param duct  Sections in the frame, as from followDuct(); those from `from` to `to` [rad] are
/// used.
AxisFrame straightened(const AxisFrame& frame, const std::vector<AxialSection>& duct, double from,
                       double to);

}  // namespace perilymph::anatomy
