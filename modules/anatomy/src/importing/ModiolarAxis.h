#pragma once

// The axis about which a scala winds.

#include <optional>
#include <vector>

#include "importing/AxialSections.h"

namespace perilymph::anatomy {

/// The axis of the spiral motion (turning, sliding, shrinking at once) that moves a surface most
/// nearly along itself: at every place p with normal n, n . (v + c x p + g p) is least in the mean
/// square over the area (kinematic surface fitting). Turned so that the surface shrinks as angles
/// grow: they grow toward the apex. None where no motion leaves the surface in place.
std::optional<AxisFrame> spiralAxis(const Surface& closed);

/// A better axis from the duct's center line: the one about which log r and z of the center line
/// are most nearly polynomials of fourth degree in the angle. A wrong axis adds waves of one turn's
/// length to both, which such polynomials cannot follow.
///
/// @param duct  Sections in the frame, as of followDuct(); those from `from` to `to` [rad] count.
AxisFrame straightened(const AxisFrame& frame, const std::vector<AxialSection>& duct, double from,
                       double to);

}  // namespace perilymph::anatomy
