// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The scala vestibuli, which an array enters after it ruptured the cochlear partition.

#include <memory>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// The scala vestibuli (scala media included) as the mirror image of the scala tympani in its own
/// roof: the same spiral, the same section upside down at every angle.
///
/// From the round window to the apex, closed there and open toward the vestibule. Derived, not
/// measured (confidence low): no section data were available. Where the mirrored section intersects
/// the turn above, the overlap remains.
Surface vestibuliSurface(const ScalaTympani& scala, int maxTriangles);

/// Height of the mirror at every section of the scala tympani's tables [m, W]: that of the membrane,
/// or of the roof if that is higher, so that the two scalae never intersect.
std::vector<double> partitionHeights(const ScalaTympani& scala);

/// The scala vestibuli of vestibuliSurface() as a duct. Its floor is the cochlear partition. Takes a
/// tenth of a second at the first call for a scala, which keeps it. Any thread.
std::shared_ptr<const ScalaTympani> vestibuliOf(const ScalaTympani& scala);

/// Both scalae as one duct without the partition: the scala tympani below its widest points, the
/// scala vestibuli above its own, vertical walls between them. Takes a tenth of a second at the first
/// call for a scala, which keeps it. Any thread.
std::shared_ptr<const ScalaTympani> bothScalaeOf(const ScalaTympani& scala);

}  // namespace perilymph::anatomy
