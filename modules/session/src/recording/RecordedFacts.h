#pragma once

// What a recording says about itself, between its table `meta` and the program's own types.

#include <optional>

#include "perilymph/session/Highlights.h"
#include "perilymph/session/Recording.h"
#include "recording/RecordingFormat.h"

namespace perilymph::session {

/// The rows of a recording that has just begun.
MetaRows metaRowsOf(const RecordingFacts& facts);

/// The facts in the rows; nothing if one is missing or is not what it must be.
std::optional<RecordingFacts> factsIn(const MetaRows& rows);

/// The highlights that were noted when the recording was closed; nothing in one from before they
/// were noted.
std::optional<Highlights> highlightsIn(const MetaRows& rows);

/// A count in the rows; nothing if it is missing or is no number.
std::optional<std::uint64_t> countIn(const MetaRows& rows, const char* key);

}  // namespace perilymph::session
