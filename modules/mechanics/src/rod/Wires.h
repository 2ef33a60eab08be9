// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Wires that yield: branches beside the elastic silicone, by return mapping.
//
// A branch of the stiffness k and the largest moment M stores, at the bend x = w - rest - q of its own,
//
//     H(x) = k |x|^2 / 2            if k |x| <= M
//          = M |x| - M^2 / (2 k)    beyond: its moment is s k x, s = min(1, M / (k |x|))
//
// with the plastic bend q of the start of the step: the energy of the step is convex, and no iteration
// is needed at a node. At the end of the step q takes up what is beyond, (1 - s) x, only where s < 1,
// and the work M |dq| is dissipated. q belongs to the material, as in Relaxation.h.

#include "lanes/Lanes.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// The fraction s of its elastic moment that a branch at the bend x has.
template <class T>
PERILYMPH_IN_LANES T elasticFraction(const Triple<T>& x, const T& stiffness,
                                     const T& moment) noexcept
{
  return moment / larger(stiffness * root(dot(x, x)), moment);
}

/// Subtracts from a stress what elastic wires would have beyond the moments that they yield at; `bent` is
/// the bend beyond rod.restBend_W.
template <class T>
PERILYMPH_IN_LANES void yieldStress(const SectionStiffness& section, const RodKinematics& rod,
                                    std::size_t i, const Triple<T>& bent,
                                    Triple<T>& stress) noexcept
{
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const Triple<T> x = bent + load<T>(rod.wireOffset_W[k], i);
    // most are, at most times
    if (inAll(dot(x, x) <= load<T>(section.elasticSquare[k], i))) continue;
    const T stiffness = load<T>(section.yielding[k].stiffness, i);
    const T over = 1.0 - elasticFraction(x, stiffness, load<T>(section.yielding[k].moment, i));
    stress = stress - (over * stiffness) * x;
  }
}

/// Sets the rest bend of all branches together, which their plastic bends move.
void setPlasticBend(const InsertionState& state, SectionStiffness& section) noexcept;

/// Moves the plastic bends of a stylet that was withdrawn by a length [m] along the array with it.
/// Needs rod.bendBefore_W.
void moveStylet(const InsertionModel& model, double withdrawn, SectionStiffness& section,
                const RodKinematics& rod, InsertionState& state) noexcept;

/// Sets what each branch is bent beyond its joint, along the axes of this step.
void offsetWires(const InsertionState& state, const SectionStiffness& section, RodKinematics& rod,
                 bool isOval) noexcept;

/// Subtracts from the matrix what yielding takes from the stiffness at node i.
void softenYielding(const SectionStiffness& section, const RodKinematics& rod, std::size_t i,
                    BandMatrix& matrix) noexcept;

/// Commits the plastic bends at the end of a step.
///
/// @return Work dissipated [J].
double yieldWires(const SectionStiffness& section, RodKinematics& rod,
                  InsertionState& state) noexcept;

}  // namespace perilymph::mechanics
