// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The opening through which the array is inserted, and whose rim its marker ribs touch.

#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// An elliptic hole with a rounded rim, in the plane of the entry.
///
/// The rim can touch the array all around, and the bone around it stops a tip that misses it. The
/// direction of insertion is the approach, in ModelParts.
struct Opening {
  Length width;       ///< Along E.x, toward the outer wall.
  Length height;      ///< Along E.y.
  Length edgeRadius;  ///< Radius of the rim.
  Length outward;     ///< Offset of its center from the entry's origin along E.x.
  Length vertical;    ///< The same along E.y.
};

/// The round window: 1.37 by 1.91 mm, the mean of 20 (SD 0.43 and 0.78; Benha Med J 2018;35:246).
/// The orientation of its long axis along E.y and the rim radius of 0.1 mm are choices (low).
Opening roundWindow();

/// A round hole drilled into the basal turn, such as the passage of the published experiment: by
/// default 1 mm wide, with a rim radius of 0.1 mm. No source states its size (choices, low): the
/// experiment shows that the 0.8 mm carrier passes freely and that the marker ribs touch the rim
/// and can be pressed past it; full insertion there is at the second rib (Todd and Naghdy).
Opening cochleostomy(Length diameter = millimeters(1));

}  // namespace perilymph::mechanics
