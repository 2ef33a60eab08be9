// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The results of a recorded insertion, as its report and tables state them.

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "perilymph/analysis/Comparison.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/PassedStop.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {

struct RecordedResults {
  ComparedInsertion insertion;
  session::Scenario scenario;
  session::Verification verification;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  haptics::Snapshot deepest{};            ///< At maximum depth; the shape is recomputed.
  haptics::TickOutput last{};             ///< At the end of the recording.
  std::vector<ContactPosition> contacts;  ///< At maximum depth, from the tip.
  std::optional<PassedStop> passedStop;   ///< Where a hand of the plans would have stopped before.
};

/// Reads a recording and replays it, in about a tenth of its duration. `stop` ends it early, with an
/// error.
Result<RecordedResults> recordedResults(const std::filesystem::path& file,
                                        const std::stop_token& stop = {});

}  // namespace perilymph::analysis
