#pragma once

// The opening that the array passes on its way in, and that its marker ribs meet at depth.

#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// An elliptic hole with a rounded rim, in the plane of the entry.
///
/// Its rim touches the array from outside all the way around, and the bone about it stops a tip
/// that misses it. Which way the array comes in is the approach, in ModelParts.
struct Opening {
  Length width;       ///< Along E.x, toward the outer wall.
  Length height;      ///< Along E.y.
  Length edgeRadius;  ///< Radius of the rim.
  Length outward;     ///< Offset of its center from the entry's origin along E.x.
  Length vertical;    ///< The same along E.y.
};

/// The round window: 1.37 by 1.91 mm, the mean of 20 (SD 0.43 and 0.78; Benha Med J 2018;35:246).
/// That its long side stands along E.y, and the rim's radius of 0.1 mm, are choices (low).
Opening roundWindow();

/// A round hole drilled into the basal turn, such as the passage of the published experiment: by
/// default 1 mm wide, with a rim rounded by 0.1 mm. No source gives its size there (choices, low):
/// the experiment shows that the carrier of 0.8 mm passes freely, that the marker ribs meet it and
/// that they can be pressed past it: full insertion is the second rib there (Todd and Naghdy).
Opening cochleostomy(Length diameter = millimeters(1));

}  // namespace perilymph::mechanics
