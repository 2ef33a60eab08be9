#pragma once

// Under which keys of the table `meta` a closed recording notes what it was like.

#include <array>
#include <utility>

#include "perilymph/session/Highlights.h"

namespace perilymph::session {

/// SI with its unit, to the last bit; the count of ticks is beside them.
inline constexpr std::array<std::pair<const char*, double Highlights::*>, 6> highlightKeys = {
    {{"duration_s", &Highlights::duration},
     {"deepest_m", &Highlights::deepest},
     {"deepest_angle_rad", &Highlights::deepestAngle},
     {"peak_force_N", &Highlights::peakForce},
     {"peak_travel_m", &Highlights::peakTravel},
     {"peak_depth_m", &Highlights::peakDepth}}};

}  // namespace perilymph::session
