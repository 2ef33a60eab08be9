// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Conversion between the table `meta` of a recording and the program's types.

#include <optional>

#include "perilymph/session/Highlights.h"
#include "perilymph/session/Recording.h"
#include "recording/RecordingFormat.h"

namespace perilymph::session {

/// The metadata rows of a new recording.
MetaRows metaRowsOf(const RecordingFacts& facts);

/// The facts in the rows; empty if one is missing or invalid.
std::optional<RecordingFacts> factsIn(const MetaRows& rows);

/// The key figures stored when the recording was closed; empty in older recordings.
std::optional<Highlights> highlightsIn(const MetaRows& rows);

/// A fact that is "0" or "1"; false if missing, empty if it is another text.
std::optional<bool> flagIn(const MetaRows& rows, const char* key);

/// A count in the rows; empty if missing or not a number.
std::optional<std::uint64_t> countIn(const MetaRows& rows, const char* key);

}  // namespace perilymph::session
