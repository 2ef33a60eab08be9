// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Comparison of two scenarios: keys, cochlea, model, appearance.

#include <string>
#include <vector>

#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// The keys in which two scenarios differ, except their titles.
std::vector<std::string> differingKeys(const session::Scenario& one,
                                       const session::Scenario& other);

/// True if both are built from the same numbers.
bool haveSameCochlea(const session::Scenario& one, const session::Scenario& other);

/// True if both have the same model to the last bit: they differ only in what concerns the device,
/// the loop or the display.
bool haveSameModel(const session::Scenario& one, const session::Scenario& other);

/// True if they look the same before anything moves.
bool lookAlike(const session::Scenario& one, const session::Scenario& other);

}  // namespace perilymph::gui
