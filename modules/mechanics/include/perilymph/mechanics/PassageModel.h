// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The passage of a drilled opening: a hole with a length.

#include <array>
#include <cstddef>
#include <vector>

#include "perilymph/mechanics/FrictionLaw.h"

namespace perilymph::mechanics {

/// Number of rings that support the array in a passage: its two edges, and three on the wall
/// between them (choice, low: over 1 mm an array bows by less than the clearance).
inline constexpr std::size_t passageRings = 5;

/// Constant data of a passage (src/contact/Passage.h).
struct PassageModel {
  double radius = 0.0;                              ///< Radius of the hole [m].
  double modulus = 0.0;                             ///< Young's modulus of what it squeezes [Pa].
  FrictionLaw friction;                             ///< Friction in it.
  std::array<double, passageRings> plane = {};      ///< Height of each ring, from 0 down [m].
  std::array<double, passageRings> stiffness = {};  ///< Stiffness of each ring [N/m].
  double spacing = 0.0;                             ///< Between the entries of the tables [m].
  /// Interference of the concentric array, ribs included, with the hole, from its tip on [m].
  std::vector<double> interference;
  /// Radial force of the hole on the array between its tip and each place [N].
  std::vector<double> radialForce;
};

}  // namespace perilymph::mechanics
