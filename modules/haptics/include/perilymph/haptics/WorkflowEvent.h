#pragma once

// The one workflow of an insertion: which state follows which.

#include <cstdint>

#include "perilymph/foundation/RealTime.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {

/// What may change the workflow.
enum class WorkflowEvent : std::uint32_t {
  arm,         ///< The user makes ready.
  grasp,       ///< The hand takes hold.
  release,     ///< The hand lets go.
  arrive,      ///< The stop depth, or on the way out the start, is reached.
  withdraw,    ///< The user asks to pull the array out.
  error,       ///< Device lost, numbers not finite, emergency stop.
  clearFault,  ///< The user says the trouble is over.
  reset,       ///< The user starts anew.
};

/// The state that follows; the same one where an event means nothing.
///
///     Idle -arm-> Armed -grasp-> Inserting -release-> Paused -grasp-> Inserting
///     Inserting -arrive-> Finished -withdraw-> Inserting
///     any -error-> Fault -clearFault-> Idle;  any -reset-> Idle
PERILYMPH_REALTIME Workflow next(Workflow now, WorkflowEvent event) noexcept;

}  // namespace perilymph::haptics
