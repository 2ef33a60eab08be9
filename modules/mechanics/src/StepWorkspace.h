#pragma once

// The memory of both models' solvers. A state has one; the model it does not belong to is of size
// 0.

#include "points/PointWorkspace.h"
#include "rod/RodWorkspace.h"

namespace perilymph::mechanics {

struct StepWorkspace {
  /// @param rodNodes  0 for a model of points.
  explicit StepWorkspace(std::size_t rodNodes) : rod(rodNodes) {}

  RodWorkspace rod;
  PointWorkspace points;
};

}  // namespace perilymph::mechanics
