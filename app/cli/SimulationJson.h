// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/Phase.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::cli {

/// Content of `simulate --json`: the scenario as run and its results.
std::string simulationJson(const session::Scenario& scenario, const analysis::ForceProfile& profile,
                           haptics::InsertionEnd end, analysis::Phase phase,
                           const haptics::LoopStatistics& statistics);

}  // namespace perilymph::cli
