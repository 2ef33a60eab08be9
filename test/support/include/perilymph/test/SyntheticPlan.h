// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Insertions of a plan with known values, as no mechanics gives them.

#include <vector>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::test {

/// A patient with A 9.2, B 6.8 and H 4.0 mm, errors of 0.1, 0.2 and 0.3 mm.
anatomy::Patient measuredPatient();

/// Draws 1 to `draws` of two arrays: A is 9 mm + draw / 1000, the angle of the first array 300 deg +
/// draw, that of the second 500; the peak force and the force on the partition draw mN; a force of draw mN at 0, 0.5 and 1 mm, in the
/// first array's first ten draws at 1.5 mm, too; two contacts, the second in odd draws only. Every
/// fourth draw is stopped by resistance, every tenth ruptures the partition.
std::vector<planning::PlannedInsertion> syntheticInsertions(std::size_t draws);

/// The thresholds that the shipped references state.
planning::Thresholds publishedThresholds();
/// The two arrays: filters at 100 and 200 Hz, and none.
std::vector<planning::PlannedArray> plannedArrays();

/// The plan of them.
planning::Plan syntheticPlan(std::size_t draws);

}  // namespace perilymph::test
