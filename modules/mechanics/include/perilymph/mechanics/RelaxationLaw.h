// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Relaxation of an array that is held bent, and of friction at rest.

#include <array>
#include <cstddef>

#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// A fraction of a stiffness that relaxes.
struct MaxwellElement {
  double fraction = 0.0;       ///< 0 to 1.
  Duration time = seconds(1);  ///< Time constant.

  bool operator==(const MaxwellElement&) const = default;
};

/// Relaxation as generalized Maxwell elements: of the carrier's bending stiffness B,
///
///     M(t) = B (1 - sum g + sum g exp(-t / tau)) kappa
///
/// at a bend kappa that was made at once. Stretching, twist and the stylet do not relax. The film is
/// the fraction of the tangential stiffness of a contact, and of its friction, that relaxes at rest.
/// Without fractions nothing relaxes.
///
/// Dummies of silicone with copper wires, held in channels of constant curvature (Huegl et al., ESAO
/// 2019, read from figures, +-1 mN; confidence low), kept 0.85 of their force for about a second and
/// 0.65 for 10 s; single cases lost 0 to 0.74 within 10 s. The fractions 0.13 with 0.3 s and 0.28 with 6 s
/// keep 0.83 and 0.64. Silicone alone hardly relaxes: wires that slide in it do, and the film.
struct RelaxationLaw {
  static constexpr std::size_t maxTerms = 2;
  std::array<MaxwellElement, maxTerms> bending;
  MaxwellElement film;

  bool bends() const noexcept;  ///< Some of the bending stiffness relaxes.
  bool hasFilm() const noexcept { return film.fraction > 0.0; }

  bool operator==(const RelaxationLaw&) const = default;
};

}  // namespace perilymph::mechanics
