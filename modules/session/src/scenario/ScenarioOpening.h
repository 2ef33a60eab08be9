// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of a scenario for the opening that the array passes and its ribs touch.

#include <functional>
#include <optional>
#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/InsertionParameters.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// Millimeters for a sentence: 27, 18.5.
std::string shortLength_mm(Length length);

/// Removes the passage of the text where an override names another opening than it. `overrideOf`
/// gives the override of a key, null without one.
void dropPassageOfOtherOpening(TomlReader& reader,
                               const std::function<const std::string*(const char*)>& overrideOf);

/// Reads the opening, where it lies, and its passage.
void readOpening(ScenarioKeys& keys, TomlReader& reader, InsertionParameters& parameters);

/// Refuses a passage that is not drilled or is longer than the straight stretch it lies in.
///
/// @param file  Name of the scenario's file, for the sentence.
Result<void> checkPassage(const std::string& file, const InsertionParameters& parameters);

/// A sentence if the array is to go deeper than it fits through the opening.
std::optional<std::string> seatNote(const InsertionParameters& parameters, Length deepest);

}  // namespace perilymph::session
