// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is inserted for a prediction: an array to its full depth, into a cochlea by its number.

#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::validation {

/// The scenario with an array, to be inserted to its full depth.
///
/// @param scenario   Shipped name or file; defines everything else.
/// @param array      Shipped name or file.
/// @param overrides  Further keys.
Result<session::Scenario> fullInsertionOf(const std::string& scenario, const std::string& array,
                                          Length startInside, Duration timeStep,
                                          const session::Overrides& overrides = {});

/// The same in the cochlea with a given number: 0 is the mean one, the others are drawn.
Result<session::InsertionParameters> withCochlea(const session::InsertionParameters& nominal,
                                                 std::uint64_t seed, std::uint64_t number);

}  // namespace perilymph::validation
