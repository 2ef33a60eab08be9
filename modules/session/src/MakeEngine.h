// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Makes the engine of a scenario, the same for a run and for its replay.

#include <memory>
#include <stdexcept>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/InsertionParameters.h"
#include "perilymph/session/RunParameters.h"

namespace perilymph::session {

/// The engine of a run.
inline Result<std::unique_ptr<haptics::InsertionEngine>> makeEngine(
    const InsertionParameters& parameters, std::shared_ptr<const mechanics::InsertionModel> model,
    const RunParameters& run)
{
  try {
    return std::make_unique<haptics::InsertionEngine>(std::move(model),
                                                      withRunParameters(parameters.engine, run));
  } catch (const std::invalid_argument& error) {
    return Error{"%1 cannot be run: %2", parameters.name, error.what()};
  }
}

}  // namespace perilymph::session
