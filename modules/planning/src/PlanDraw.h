// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One draw of everything that is uncertain; the same for all arrays, so that they can be compared.

#include <array>
#include <cstdint>
#include <optional>

#include "Uncertainty.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/anatomy/IndividualShape.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::planning {

/// A cochlea that the patient may have, an approach, a hand, and how far stiffness is off.
struct PlanDraw {
  anatomy::Patient patient;
  std::array<double, 2> sharing{};  ///< Standard normal: how A and B are shared between both sides.
  anatomy::IndividualShape shape;   ///< With that sharing, and what varies along the scala.
  Length lining;
  Stiffness membrane;
  Angle tilt, turn;               ///< Added to the scenario's approach.
  double stiffnessDeviate = 0.0;  ///< Standard normal.
  double packing = 0.0;  ///< c of the wires of arrays that have one (electrode::wirePacking()).
  double taper = 0.0;    ///< Place in the range of arrays that state one: 0, thinnest, to 1.
  analysis::Surgeon surgeon;
};

/// Draw `number` of a seed: the same on every machine, in any order. The measures are normal with
/// the errors and correlations that the patient's file states (analysis::errorsOf()), within what a
/// patient may have.
///
/// @param patient  With A and B.
PlanDraw drawPlan(const anatomy::Patient& patient, const Uncertainty& uncertainty,
                  const analysis::HandDistribution& hand, std::uint64_t seed, std::uint64_t number,
                  const session::FrictionSpread& friction = {});

/// The factor of an array's bending and twisting stiffness: log-normal with mean 1.
double stiffnessFactor(const PlanDraw& draw, double deviation);

/// The parameters of an array in a draw's cochlea, by its approach and with its stiffness.
/// Without a resolution, nodes and time step are the nominal ones.
session::InsertionParameters drawnParameters(const session::InsertionParameters& nominal,
                                             const PlanDraw& draw, double stiffness,
                                             const std::optional<Resolution>& resolution);

}  // namespace perilymph::planning
