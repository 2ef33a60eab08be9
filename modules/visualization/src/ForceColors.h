// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The color map of wall force: from transparent to a low and a high color, perceptually uniform.

#include "SceneColors.h"

namespace perilymph::visualization {

/// Wall force per millimeter of array at the end of the map [mN/mm]. Fixed, so that pictures of
/// different insertions are comparable. A choice: about the force of the published array behind the
/// opening when its tip reaches the basal turn.
inline constexpr double maxWallForce_mN_mm = 50.0;

/// Color and opacity for a force per length, clamped at the end of the map. Its luminance moves away
/// from that of the ground throughout, so that the greatest force stands out for everybody: from red
/// to bright yellow on a dark ground, from yellow to dark red on a light one.
Rgba forceColor(double force_mN_mm, figures::ColorScheme scheme);

}  // namespace perilymph::visualization
