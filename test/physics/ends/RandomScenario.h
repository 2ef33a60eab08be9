// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Scenarios drawn at random over everything that the files allow.

#include <cstdint>
#include <string>

#include "perilymph/session/Scenario.h"

namespace perilymph::test {

/// Names of all shipped arrays, sorted.
std::vector<std::string> shippedArrays();

/// The maximum stop travel of an array [mm], from a start inside [mm].
double maxStopTravel_mm(const std::string& array, double startInside_mm);

/// Changed keys of "contour-published": cochlea, array, opening, friction, approach to 30 degrees,
/// speed, nodes, start. The same number gives the same keys.
session::Overrides randomScenario(std::uint64_t seed, std::uint64_t number);

}  // namespace perilymph::test
