// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One step of Newton's method: computation and application.

#include "solver/Residual.h"

namespace perilymph::mechanics {

/// Factorizes the stiffness at the last residual. Past its buckling load the exact matrix is
/// indefinite; then it leaves compression out, which is always positive definite, and states it in
/// `compression`. False only if that is impossible.
bool factorize(const InsertionModel& model, const InsertionState& state, const Base& base,
               Compression& compression, RodWorkspace& work) noexcept;

/// Computes the Newton step of every block, into system.trial_W.
///
/// @return Length of the longest block step [m].
double solveLinearSystem(LinearSystem& system) noexcept;

/// Moves every node by a fraction of the Newton step that starts at system.start_W. An edge that
/// rotates moves on an arc, with the change of length given by the step's component along it. On a
/// straight path its length would grow quadratically with the rotation, against the rod's largest
/// stiffness.
void moveBy(LinearSystem& system, double alpha, std::vector<Eigen::Vector3d>& position_W) noexcept;

/// Directional derivative: work of the unbalanced forces along the step [J].
double directionalDerivative(const LinearSystem& system) noexcept;

/// The same after a fraction of the step, along the arcs [J].
double directionalDerivativeAt(LinearSystem& system, double alpha) noexcept;

}  // namespace perilymph::mechanics
