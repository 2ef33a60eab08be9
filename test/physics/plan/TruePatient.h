// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Virtual patients whose cochlea is known in full, and whose measures have errors.
//
// Their shape is of another family than a plan's: a plan draws the mean of 15 measured cochleae,
// scaled to A, B and H, with random variations around it. A true cochlea is Clark's template spiral, another shape of center line and
// rise, with half-diameters of the population and its A + B, three waves of the radius around the turns, a rise of
// its own, and sections whose size changes from base to apex.

#include <cstdint>
#include <memory>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::test {

/// A true cochlea and what a measurement of it gives.
struct TruePatient {
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  anatomy::BasalTurn truth;   ///< Measured in the lumen without error.
  anatomy::Patient measured;  ///< With errors, drawn as they are stated.
};

/// Patient `number` of a seed.
Result<TruePatient> truePatient(std::uint64_t seed, std::uint64_t number);

}  // namespace perilymph::test
