// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/advance.h"

#include "StepWorkspace.h"
#include "points/advancePoints.h"
#include "rod/advanceRod.h"

namespace perilymph::mechanics {

void advance(const InsertionModel& model, InsertionState& state, const Drive& drive) noexcept
{
  StepWorkspace& workspace = *state.workspace;
  if (model.points)
    advancePoints(model, state, drive, workspace.points);
  else
    advanceRod(model, state, drive, workspace.rod);
}

}  // namespace perilymph::mechanics
