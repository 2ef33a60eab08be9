// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One pass of a recording through the engine, shared by verification and playback.

#include <functional>
#include <string>
#include <vector>

#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// Messages about changes since the recording was made.
std::vector<Sentence> whatChanged(const RecordedInsertion& recorded, const Scenario& scenario,
                                  const mechanics::InsertionModel& model);

/// Checks the consistency of the file and fills the first part of a verification.
Result<Verification> beginVerification(const RecordedInsertion& recorded);

/// Feeds recorded samples and commands through a new engine and compares every output field bit by
/// bit up to the first difference. Ends at lost ticks, at the end of the recording, or when
/// `after`, called after every tick, returns false.
Result<void> replayThrough(const RecordedInsertion& recorded, haptics::InsertionEngine& engine,
                           Verification& verification, const std::function<bool()>& after);

}  // namespace perilymph::session
