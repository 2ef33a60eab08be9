// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Frame of the anatomy and surface of a measured cochlea.

#include "LumenWall.h"
#include "Pose.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// Sets the frame of the anatomy: the sections' frame, turned about its axis so that 0 degrees is at
/// the measured round window.
void placeAnatomy(const Pose& pose, CochleaMeasures& measures);

/// Adds points and triangles of the wall.
void addWall(const LumenWall& wall, const Pose& pose, CochleaMeasures& measures);

}  // namespace perilymph::ct
