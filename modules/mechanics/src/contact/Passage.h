// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The passage of a drilled opening: contact between the array and a hole with a length.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "contact/ContactSet.h"
#include "contact/Crossing.h"
#include "friction/FrictionHistory.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// The tables of the opening's passage; none if it is a thin rim. `model` is complete otherwise.
std::optional<PassageModel> passageOf(const InsertionModel& model);

/// Adds the forces of the passage on an array that crosses its outer edge at `outer` to force_W, and
/// stores contact and stiffness in `contacts`.
///
/// Three parts form one energy, of which every force is the gradient:
///
///     squeeze    U = 2 pi E integral m(s)^2 ds     between the two edges
///     edges      U = compliant wall law of p, at the outer and at the inner edge, without ribs
///     wall       the same with ribs at rings between them, each for its part of the length
///
/// m(s) is the interference of the concentric array, ribs included, with the hole at the distance s
/// from the tip: a solid cylinder of modulus E and Poisson's ratio 1/2 that can expand along its axis
/// is pressed by p = 2 E m / R. Because m belongs to the array, the derivative of the integral is
/// that at its limits: a rib pushes back at the outer edge while it enters, and forward at the inner
/// edge while it leaves; in between it only rubs. A fraction of what it gives there may be lost
/// (Opening::ribExitLoss), as a force against the motion in either direction. p is the overlap of the array at one side, the
/// distance of its axis from that of the hole minus the clearance there, which ends smoothly at a
/// rib. A ring sets in over one radius of the tip once it has passed.
///
/// Friction acts along the passage, bounded by the sum of all normal forces in the previous step,
/// and on the outer edge: the array is too stiff along its axis for the place to matter.
void addPassageForces(const InsertionModel& model, const InsertionState& state,
                      const StepStart& start, const FrictionHistory& history, const Crossing& outer,
                      ContactSet& contacts, std::vector<Eigen::Vector3d>& force_W) noexcept;

}  // namespace perilymph::mechanics
