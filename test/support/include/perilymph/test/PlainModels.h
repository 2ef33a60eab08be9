// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Insertions with simple geometry: a round array in a round duct.

#include <memory>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::test {

/// A straight array: 22 mm long, 0.5 mm thick, EI 1e-6 N.m^2, no stylet.
electrode::ArrayDesign plainArray();

/// That array in a wide straight tube, tip 2 mm inside, without contact.
///
/// @param timeStep  Of the model.
std::shared_ptr<const mechanics::InsertionModel> insertionInTube(
    Duration timeStep = milliseconds(1));

/// That array in a toroidal duct (section radius 0.6 mm, bend radius 4 mm, 3 mm straight lead), tip
/// 2 mm inside: it bends along the outer wall.
std::shared_ptr<const mechanics::InsertionModel> insertionInRing();

}  // namespace perilymph::test
