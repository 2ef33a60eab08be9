// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The array of a frame as a triangle surface.

#include "perilymph/anatomy/Surface.h"
#include "perilymph/broadcast/BroadcastFrame.h"

namespace perilymph::broadcast {

/// The carrier, without ribs and stylet: elliptic rings of 16 points around the nodes, the diameter
/// within the plane of curl toward the modiolar axis; round at the tip, flat at the base, closed. The
/// 16-gons are inscribed: at most 2 % narrower than the ellipse. Empty without nodes or
/// without a width at the tip.
anatomy::Surface arraySurface(const BroadcastFrame& frame);

}  // namespace perilymph::broadcast
