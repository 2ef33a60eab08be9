// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The contacts for whoever programs the sound processor: place, frequency by two maps, default filter and
// mismatch, of a plan or of one insertion, in the same columns.

#include <string>
#include <vector>

#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// One row per contact of each array, with bands from 5 to 95 %. Frequencies of the spiral ganglion at the
/// bounds of a band are those at the bounds of its angle.
std::string contactsCsv(const Plan& plan);
/// The same for some arrays of a plan.
std::string contactsCsv(const Plan& plan, const std::vector<std::size_t>& arrays);

/// The same columns of one insertion, without bands.
///
/// @param name      Of the array, for the first column.
/// @param contacts  From the tip.
/// @return          An error if the shipped filters cannot be read.
Result<std::string> insertionContactsCsv(const std::string& name,
                                         const electrode::ArrayDesign& array,
                                         const std::vector<analysis::ContactPosition>& contacts);

/// `column, unit, meaning, source`: a row for each column of these tables, in their order.
std::string contactsDictionaryCsv();

}  // namespace perilymph::planning
