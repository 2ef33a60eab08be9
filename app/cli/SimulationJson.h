#pragma once

#include <string>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/Phase.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::cli {

/// What `simulate --json` writes: the scenario as run and what came of it.
std::string simulationJson(const session::Scenario& scenario, const analysis::ForceProfile& profile,
                           analysis::Phase phase, const haptics::LoopStatistics& statistics);

}  // namespace perilymph::cli
