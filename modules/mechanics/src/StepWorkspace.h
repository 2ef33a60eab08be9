// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Memory of the solvers of both models. A state has one workspace; the part of the other model has
// size 0.

#include "points/PointWorkspace.h"
#include "rod/RodWorkspace.h"

namespace perilymph::mechanics {

struct StepWorkspace {
  /// @param rodNodes  0 for a point set.
  explicit StepWorkspace(std::size_t rodNodes) : rod(rodNodes) {}

  RodWorkspace rod;
  PointWorkspace points;
};

}  // namespace perilymph::mechanics
