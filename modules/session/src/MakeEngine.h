// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Makes the engine of a scenario, the same for a run and for its replay.

#include <memory>
#include <stdexcept>

#include "perilymph/session/RunParameters.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// The engine of a run.
inline Result<std::unique_ptr<haptics::InsertionEngine>> makeEngine(
    const Scenario& scenario, std::shared_ptr<const mechanics::InsertionModel> model,
    const RunParameters& run)
{
  try {
    return std::make_unique<haptics::InsertionEngine>(std::move(model),
                                                      withRunParameters(scenario.engine, run));
  } catch (const std::invalid_argument& error) {
    return Error{scenario.name + " cannot be run: " + error.what()};
  }
}

}  // namespace perilymph::session
