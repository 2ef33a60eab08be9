// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cracks of a surface: corners of one triangle that were moved away from its neighbors.

#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::anatomy {

/// Closes cracks: a corner of one triangle alone, which its neighbors' free edges lead past, is
/// welded to the corner they lead to.
///
/// - If both free edges of the triangle have a counterpart with the same end, the wall there lacks
///   exactly this triangle: it is welded where the gap is at most 0.35 mm or the edges there, and
///   refused as a tear where it is wider.
/// - If only one has, as where the triangle was part of the rim of an opening, the corner may also
///   be a tooth of a rim cut from a mesh: it is welded where the gap is at most a quarter of the
///   shorter edge beside it. Where there are at most two such corners, they are judged like those
///   with two counterparts. A tooth on a straight rim is left as it is.
///
/// Corners are shared by triangles. A surface without such corners is left as it is.
Result<void> closeCracks(Surface& surface);

}  // namespace perilymph::anatomy
