// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How deep the simulations of a plan would end at any force limit: their pushes again, without a stop.

#include <cstddef>
#include <stop_token>
#include <vector>

#include "perilymph/analysis/RunProgress.h"
#include "perilymph/analysis/StopCurve.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanRequest.h"

namespace perilymph::planning {

/// One simulation of an array without a stop, and what stopped it in the plan.
struct UnstoppedDraw {
  std::size_t draw = 0;   ///< From 1, as PlannedInsertion::draw.
  double friction = 1.0;  ///< Factor of the scenario's, as PlannedInsertion::friction.
  Force stop;             ///< Force at which its surgeon stops.
  Length intended;        ///< Depth at which its surgeon means to stop.
  analysis::StopCurve curve;
};

/// Pushes an array again in simulations of a plan: cochlea, hand, friction, stiffness, approach and
/// resolution are theirs, to the bit. Each takes about as long as the plan's own.
///
/// @param array  Index into the request's arrays.
/// @param first  Number of the first simulation, from 1.
/// @param count  Number of simulations.
/// @param stop   Ends it early, with an error.
/// @return       By simulation. The errors are those of makePlan(), and an array that the request has not.
Result<std::vector<UnstoppedDraw>> unstoppedDraws(const PlanRequest& request, std::size_t array,
                                                  std::size_t first, std::size_t count,
                                                  const analysis::RunProgress& progress = {},
                                                  const std::stop_token& stop = {});

}  // namespace perilymph::planning
