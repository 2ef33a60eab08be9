// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The passage of a drilled opening: a hole with a length.

#include <array>
#include <cstddef>
#include <vector>

#include "perilymph/mechanics/FrictionLaw.h"

namespace perilymph::mechanics {

/// Longest passage [m]: the bone over the basal turn is 1 to 2 mm thick (choice, low).
inline constexpr double longestPassage = 2e-3;

/// Largest distance between the rings that stand for the wall of a passage [m]: a third of the reach
/// of a rib, so that it slides from ring to ring without a ripple.
inline constexpr double passageRingSpacing = 0.1e-3;

/// Maximum number of rings: those on the wall, and both edges.
inline constexpr std::size_t maxPassageRings = 22;

/// Constant data of a passage (src/contact/Passage.h).
struct PassageModel {
  double radius = 0.0;    ///< Radius of the hole [m].
  double modulus = 0.0;   ///< Young's modulus of what it squeezes [Pa].
  FrictionLaw friction;   ///< Friction in it.
  double exitLoss = 0.0;  ///< Fraction of the energy that is lost at the inner edge.
  std::size_t rings = 0;  ///< The outer edge, rings on the wall, and the inner edge.
  std::array<double, maxPassageRings> plane = {};      ///< Height of each ring, from 0 down [m].
  std::array<double, maxPassageRings> stiffness = {};  ///< Stiffness of each ring [N/m].
  double spacing = 0.0;                                ///< Between the entries of the tables [m].
  /// Interference of the concentric array, ribs included, with the hole, from its tip on [m].
  std::vector<double> interference;
  /// Radial force of the hole on the array between its tip and each place [N].
  std::vector<double> radialForce;
};

}  // namespace perilymph::mechanics
