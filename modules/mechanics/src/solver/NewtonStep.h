#pragma once

// One step of Newton's method: found, and taken in whole or in part.

#include "solver/Residual.h"

namespace perilymph::mechanics {

/// Factors of the stiffness at the last balance. False only if there are none.
bool factorize(const InsertionModel& model, const Base& base, RodWorkspace& work) noexcept;

/// The Newton step of every block, into system.trial_W.
///
/// @return The longest of them [m].
double solveLinearSystem(LinearSystem& system) noexcept;

/// Moves every node by a share of the Newton step that starts at system.start_W. Where the step
/// turns an edge, the edge turns on an arc: it gets just as long as the step says along it. On a
/// straight way it would grow by the square of the turn, against the rod's stiffest resistance.
void moveBy(const LinearSystem& system, double alpha,
            std::vector<Eigen::Vector3d>& position_W) noexcept;

/// How strongly the unbalanced forces pull along the step [J].
double directionalDerivative(const LinearSystem& system) noexcept;

/// The same where a share of the step has been gone, along the arcs [J].
double directionalDerivativeAt(const LinearSystem& system, double alpha) noexcept;

}  // namespace perilymph::mechanics
