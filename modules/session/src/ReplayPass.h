#pragma once

// One pass of a recording through the engine: the same for a verification and for a playback.

#include <functional>
#include <string>
#include <vector>

#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// Sentences about what is not as it was when the recording was made.
std::vector<std::string> whatChanged(const RecordedInsertion& recorded, const Scenario& scenario,
                                     std::uint64_t modelFingerprint);

/// Checks that the file holds what was recorded; begins the answer of a verification with it.
Result<Verification> beginVerification(const RecordedInsertion& recorded);

/// Feeds recorded samples and commands through an engine that has not ticked yet, and compares
/// every output field bit by bit until one differs. Ends where ticks were lost, where the recording
/// ends, or where `after` gives false; it is called after every tick.
Result<Done> replayThrough(const RecordedInsertion& recorded, haptics::InsertionEngine& engine,
                           Verification& verification, const std::function<bool()>& after);

}  // namespace perilymph::session
