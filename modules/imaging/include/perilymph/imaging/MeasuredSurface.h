// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The wall of a cochlea measured in a CT, as a surface for other programs.

#include "perilymph/anatomy/Surface.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::imaging {

inline constexpr const char* measuredSurfaceTitle =
    "Perilymph, wall of a cochlea measured in a CT, LPS";

/// The fitted wall as it lies in the CT (LPS, in meters), its normals outward.
anatomy::Surface measuredSurface(const ct::CochleaMeasures& measures);

}  // namespace perilymph::imaging
