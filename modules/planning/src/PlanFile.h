// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The draws of a plan in a SQLite file, so that a plan can be interrupted and continued
// (session::InsertionTable).
//
// Tables: meta(key, value) with fingerprint, program and the seal; insertion(draw, array, content),
// the content as JSON in SI units, which keeps every bit.

#include <optional>
#include <string>
#include <vector>

#include "perilymph/planning/PlanResult.h"
#include "perilymph/session/InsertionTable.h"

namespace perilymph::planning {

/// The kind of file, and the facts of a plan that this program makes.
const session::InsertionTableKind& planKind();
SealedFacts planFacts(const std::string& fingerprint);

/// Draws as rows.
std::vector<session::InsertionRows> rowsOf(const std::vector<PlannedInsertion>& insertions);

/// The insertions of all whole draws, by draw and array. Refuses what no plan has.
Result<std::vector<PlannedInsertion>> insertionsIn(const session::InsertionTable& table);

/// An insertion as text of a row, and back. Refuses any other text, and values that no insertion has.
std::string contentOf(const PlannedInsertion& insertion);
Result<PlannedInsertion> insertionIn(const std::string& content);

}  // namespace perilymph::planning
