// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The state machine of an insertion.

#include <cstdint>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {

/// Events of the workflow.
enum class WorkflowEvent : std::uint32_t {
  arm,      ///< The user arms the insertion.
  grasp,    ///< The hand grasps.
  release,  ///< The hand releases, or the user stops.
  arrive,   ///< The stop travel, on withdrawal the initial depth, or an early end (InsertionEnd.h).
  withdraw,  ///< The user requests withdrawal of the array.
  error,     ///< Device lost, values not finite.
};

/// The next state; unchanged if the event does not apply.
///
///     Idle -arm-> Armed -grasp-> Inserting -release-> Paused -grasp-> Inserting
///     Inserting -arrive-> Finished -withdraw-> Inserting
///     any -error-> Fault
Workflow next(Workflow now, WorkflowEvent event) noexcept;

}  // namespace perilymph::haptics
