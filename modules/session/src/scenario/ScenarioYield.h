// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of a scenario that let wires or a stylet yield. Without them both are elastic, but for an array
// whose own file gives a yield stress.

#include <optional>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/InsertionParameters.h"
#include "perilymph/session/Scenario.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// Yield stresses that a scenario gives.
struct AskedYield {
  std::optional<Modulus> wires, stylet;
};

/// Reads them and notes those given.
AskedYield readYield(TomlReader& reader, ScenarioKeys& keys, mechanics::ModelKind model);

/// Lets the scenario's array, before its calibration, yield at them; refuses what its file excludes, and
/// a calibration by name, which was fitted to forces of the array as elastic.
Result<void> applyYield(const AskedYield& asked, const std::string& file,
                        ScenarioContent& scenario);

}  // namespace perilymph::session
