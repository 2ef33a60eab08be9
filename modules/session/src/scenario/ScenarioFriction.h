// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Friction keys of a scenario.

#include <functional>
#include <string>

#include "perilymph/mechanics/FrictionLaw.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

// Measured on tissue-like lining: 0.24 to 0.59 (Dohr 2021); 1 leaves a margin and keeps the solver
// stable.
inline constexpr Range frictionRange{0.0, 1.0};
// Hands reach up to 200 mm/s when they slip.
inline constexpr Range frictionSpeed_mm_s{0.0, 200.0};
inline constexpr Range stribeckRange_mm_s{0.001, 100.0};

/// Reads `friction`, a preset, and the keys that take precedence over it.
///
/// @param isOverridden  Whether a key was overridden; a preset given as an override replaces all
///                      values of the text except overridden ones.
void readFriction(TomlReader& reader, ScenarioKeys& keys,
                  const std::function<bool(const std::string&)>& isOverridden,
                  mechanics::FrictionLaw& law);

}  // namespace perilymph::session
