#pragma once

// Newton's method for the balance of forces.

#include "Balance.h"

namespace perilymph::mechanics {

/// How a step's iteration ended.
struct Settled {
  Balance left;
  int iterations;
};

/// Moves the nodes from state.position_W until no force is left unbalanced: Newton's method with a
/// line search on the residual. Stops at 2 uN, at a motion of 1 nm, or after 16 iterations.
Settled settle(const InsertionModel& model, InsertionState& state, const Base& base) noexcept;

}  // namespace perilymph::mechanics
