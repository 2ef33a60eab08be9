// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of a scenario for relaxation. Without them nothing relaxes, as in all earlier texts.

#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/InsertionParameters.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// Reads the fractions and time constants of the bending stiffness and of the friction film, and notes
/// those given.
void readRelaxation(TomlReader& reader, ScenarioKeys& keys, const InsertionParameters& parameters,
                    mechanics::RelaxationLaw& law);

}  // namespace perilymph::session
