// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of a scenario for the compliance of wall and rim.

#include <functional>
#include <string>

#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/session/InsertionParameters.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// Removes the wall of the text where an override names another cochlea or model than it: the wall
/// belongs to these. `overrideOf` gives the override of a key, null without one.
void dropWallOfOtherCochlea(TomlReader& reader,
                            const std::function<const std::string*(const char*)>& overrideOf);

/// Reads the wall. Without keys, a published cochlea without a patient, and the published point
/// set, have the published wall; every other cochlea has bone under a thin soft lining.
void readWall(ScenarioKeys& keys, TomlReader& reader, const std::string& patient,
              const InsertionParameters& parameters, mechanics::WallLaw& wall);

}  // namespace perilymph::session
