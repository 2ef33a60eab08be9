// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of the table `meta` for the key figures of a closed recording.

#include <array>
#include <utility>

#include "perilymph/session/Highlights.h"

namespace perilymph::session {

/// In SI with the unit, exact; the number of ticks is stored separately.
inline constexpr std::array<std::pair<const char*, double Highlights::*>, 6> highlightKeys = {
    {{"duration_s", &Highlights::duration},
     {"deepest_m", &Highlights::deepest},
     {"deepest_angle_rad", &Highlights::deepestAngle},
     {"peak_force_N", &Highlights::peakForce},
     {"peak_travel_m", &Highlights::peakTravel},
     {"peak_depth_m", &Highlights::peakDepth}}};

/// How the insertion ended, by haptics::nameOf().
inline constexpr const char* highlightEnd = "end";

}  // namespace perilymph::session
