#pragma once

// The keys of a scenario that say how the array slides.

#include <functional>
#include <string>

#include "perilymph/mechanics/FrictionLaw.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

// Measured on tissue-like lining: 0.24 to 0.59 (Dohr 2021); 1 leaves room and keeps the solver
// safe.
inline constexpr Range frictionRange{0.0, 1.0};
// Hands slip at up to 200 mm/s.
inline constexpr Range frictionSpeed_mm_s{0.0, 200.0};
inline constexpr Range stribeckRange_mm_s{0.001, 100.0};

/// Reads `friction`, a preset, and the keys whose values stand before its own.
///
/// @param isOverridden  Whether a key was given anew; a preset named anew replaces all values of
///                      the text but those.
void readFriction(TomlReader& reader, ScenarioKeys& keys,
                  const std::function<bool(const std::string&)>& isOverridden,
                  mechanics::FrictionLaw& law);

}  // namespace perilymph::session
