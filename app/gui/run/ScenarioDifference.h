#pragma once

// How two scenarios differ: in their keys, their cochlea, their model, their looks.

#include <string>
#include <vector>

#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// The keys in which two scenarios differ, but for their titles.
std::vector<std::string> differingKeys(const session::Scenario& one,
                                       const session::Scenario& other);

/// True if both are built from the same numbers.
bool haveSameCochlea(const session::Scenario& one, const session::Scenario& other);

/// True if both are the same model to the last bit: they differ at most in what only the hand, the
/// loop or people use.
bool haveSameModel(const session::Scenario& one, const session::Scenario& other);

/// True if they look alike before anything moves.
bool lookAlike(const session::Scenario& one, const session::Scenario& other);

}  // namespace perilymph::gui
