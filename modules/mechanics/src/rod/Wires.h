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

#include <utility>

#include "lanes/Lanes.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

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

/// The part of the rest bend that the plastic bends of all branches make, along the two axes.
template <class T>
PERILYMPH_IN_LANES std::pair<T, T> setOfWires(const InsertionState& state,
                                              const SectionStiffness& section,
                                              std::size_t i) noexcept
{
  const T inverse = 1.0 / load<T>(section.bending, i);
  T along{}, across{};
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const T fraction = inverse * load<T>(section.yielding[k].stiffness, i);
    along = along + fraction * load<T>(state.plasticBend[k].along, i);
    across = across + fraction * load<T>(state.plasticBend[k].across, i);
  }
  return {along, across};
}

/// Moves the plastic bends of a stylet that was withdrawn by a length [m] along the array with it.
/// Needs rod.bendBefore_W.
void moveStylet(const InsertionModel& model, double withdrawn, SectionStiffness& section,
                const RodKinematics& rod, InsertionState& state) noexcept;

/// Sets what each branch is bent beyond its joint, along the axes of this step.
///
/// @param along, across            Axes of the node.
/// @param heldAlong, heldAcross    What the rest bend holds along them, beyond that of the carrier.
template <class T>
PERILYMPH_IN_LANES void offsetWires(const InsertionState& state, const SectionStiffness& section,
                                    RodKinematics& rod, std::size_t i, const Triple<T>& along,
                                    const Triple<T>& across, const T& heldAlong,
                                    const T& heldAcross, bool isOval) noexcept
{
  if (isOval)
    store(load<T>(section.setAlong, i) * along + load<T>(section.setAcross, i) * across, rod.set_W,
          i);
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const T offAlong = heldAlong - load<T>(state.plasticBend[k].along, i);
    const T offAcross = heldAcross - load<T>(state.plasticBend[k].across, i);
    store(offAlong * along + offAcross * across, rod.wireOffset_W[k], i);
  }
}

/// Commits the plastic bends of a node, or of four, at the end of a step; `bent` as for yieldStress().
///
/// @return  Work dissipated [J].
template <class T>
PERILYMPH_IN_LANES T yieldWires(const SectionStiffness& section, const RodKinematics& rod,
                                std::size_t i, const Triple<T>& bent, const Triple<T>& along,
                                const Triple<T>& across, InsertionState& state) noexcept
{
  T work{};
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const Triple<T> x = bent + load<T>(rod.wireOffset_W[k], i);
    if (inAll(dot(x, x) <= load<T>(section.elasticSquare[k], i))) continue;
    MaterialBend& plastic = state.plasticBend[k];
    const T moment = load<T>(section.yielding[k].moment, i);
    const T over = 1.0 - elasticFraction(x, load<T>(section.yielding[k].stiffness, i), moment);
    store(T(load<T>(plastic.along, i) + over * dot(x, along)), plastic.along, i);
    store(T(load<T>(plastic.across, i) + over * dot(x, across)), plastic.across, i);
    work = work + moment * over * root(dot(x, x));
  }
  return work;
}

}  // namespace perilymph::mechanics
