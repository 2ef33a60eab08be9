// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Friction keys of a scenario.

#include <functional>
#include <string>

#include "perilymph/mechanics/FrictionLaw.h"
#include "perilymph/session/InsertionParameters.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// Reads `friction`, a preset, and the keys that take precedence over it.
///
/// @param isOverridden  Whether a key was overridden; a preset given as an override replaces all
///                      values of the text except overridden ones.
void readFriction(TomlReader& reader, ScenarioKeys& keys,
                  const std::function<bool(const std::string&)>& isOverridden,
                  mechanics::FrictionLaw& law, FrictionSpread& spread);

}  // namespace perilymph::session
