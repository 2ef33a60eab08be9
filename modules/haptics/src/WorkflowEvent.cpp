// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/WorkflowEvent.h"

namespace perilymph::haptics {

Workflow next(Workflow now, WorkflowEvent event) noexcept
{
  switch (event) {
    case WorkflowEvent::error:
      return Workflow::fault;
    case WorkflowEvent::arm:
      return now == Workflow::idle ? Workflow::armed : now;
    case WorkflowEvent::grasp:
      return now == Workflow::armed || now == Workflow::paused ? Workflow::inserting : now;
    case WorkflowEvent::release:
      return now == Workflow::inserting ? Workflow::paused : now;
    case WorkflowEvent::arrive:
      return now == Workflow::inserting ? Workflow::finished : now;
    case WorkflowEvent::withdraw:
      return now == Workflow::finished ? Workflow::inserting : now;
  }
  return now;
}

}  // namespace perilymph::haptics
