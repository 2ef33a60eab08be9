// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The longest that a time step of a model can take on this machine.

#include <optional>

#include "perilymph/foundation/Result.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::haptics {

/// The work of a time step is bounded by SolverParameters; this is its time.
struct TickBound {
  double time = 0.0;           ///< A tick that uses all the work it may [s].
  double evaluation = 0.0;     ///< One evaluation of all forces [s].
  double factorization = 0.0;  ///< One factorization of the stiffness [s].
  int evaluations = 0;         ///< The most in a measured tick.
  int factorizations = 0;      ///< The most in a measured tick.
};

/// Measures ticks that are solved to no tolerance, deep in the cochlea under a hand that jerks at 50
/// mm/s, with factors of the stiffness that are kept and with factors that are renewed in every
/// iteration. Least squares of the processor time of their faster half, which other work on the machine
/// disturbs least, give the time of an evaluation and of a factorization; a tick that uses the bounds of
/// both takes the result, and a tenth is added for the loop around it. Takes 25 to 40 ms with 100 nodes.
/// Empty for a point set, whose work does not vary.
std::optional<TickBound> measureTickBound(const mechanics::InsertionModel& model);

/// Refuses a model of which a tick can take longer than its time step and than 1 ms, by five measurements,
/// with the number of nodes that this machine can bound.
Result<void> checkTickBound(const mechanics::InsertionModel& model);

}  // namespace perilymph::haptics
