// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One time step of an insertion.

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {

/// Advances the state by one time step. A point set (`model.points`) goes its own way, see
/// points/advancePoints.h. A rod takes one step of backward Euler, in these stages:
///
///     setStiffness        rod/Rod.h            bending and rest bend for the stylet's position
///     findBone            contact/Clearance.h  nodes beside bone in front of the opening
///     findSides           contact/OpenPartition.h  side of a ruptured partition of each node
///     setGuide            contact/Guide.h      line on which forceps hold the array
///     setRestShape        rod/Rod.h            rest bends along the rod
///     turnMaterial        rod/Material.h       twist at minimum energy, if the array twists
///     baseOf              solver/Residual.h    how the hand holds the base
///     setHold             solver/Residual.h    inertia and drag as springs
///     predict             rod/Step.cpp         positions by the velocities and their trend
///     solveNewton         solver/Newton.h      equilibrium of rod, wall, rim, membrane and friction;
///                                              every iteration lowers the energy
///     commitStep          rod/Step.h           velocities, friction and contacts of the next step
///     read                rod/advanceRod.cpp   reaction at the base, into state.readings
///     contactWithPartition, rupturePartition   contact/PartitionRupture.h; of a balanced step
///
/// The work is bounded and its precision set by SolverParameters. The iteration ends at 2 uN of
/// unbalanced force on a node, or earlier if it makes no progress or has used its work; up to 0.1 mN is
/// then accepted as balanced. A step with more, as when an array snaps, is continued in the next one
/// from its configuration, with zero velocity (state.isSettling), and the readings hold the gradient of
/// the energy there.
///
/// Pure: no clock, no file, no randomness, bounded work. The same model, state and drive give the
/// same bits on every x86-64 machine. Real-time safe.
void advance(const InsertionModel& model, InsertionState& state, const Drive& drive) noexcept;

}  // namespace perilymph::mechanics
