// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The opening through which the array is inserted, and whose rim its marker ribs touch.

#include <optional>

#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// An elliptic hole with a rounded rim, in the plane of the entry.
///
/// Its rim is thin, as that of a round window, or the edge of a drilled passage behind the plane.
/// The rim can touch the array all around, and the bone around it stops a tip that misses it. The
/// direction of insertion is the approach, in ModelParts.
struct Opening {
  Length width;       ///< Along E.x, toward the outer wall.
  Length height;      ///< Along E.y.
  Length edgeRadius;  ///< Radius of the rim.
  Length outward;     ///< Offset of its center from the entry's origin along E.x.
  Length vertical;    ///< The same along E.y.
  /// Length of the hole behind its outer edge, if it is round; 0: a thin rim.
  Length passage = millimeters(0);
  /// Young's modulus of the array where the passage squeezes it. Silicone: 2.0 MPa at the usual
  /// ratio of base to curing agent (Wang et al. 2014, J Appl Polym Sci 131:41050), 1.32 to 2.97 MPa
  /// by curing (Johnston et al. 2014, J Micromech Microeng 24:035017); medium, wires left out.
  Modulus passageModulus = megapascals(2.0);
  /// Coefficient of friction in the passage; that of the wall if empty.
  std::optional<double> passageFriction = std::nullopt;
  /// Fraction of a rib's elastic energy that is lost where it leaves the passage, 0 to 1. Silicone has
  /// hysteresis, and a fin that folds back gives nothing; of both nothing was measured (choice, low).
  double ribExitLoss = 0.0;
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
