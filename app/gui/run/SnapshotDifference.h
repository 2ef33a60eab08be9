// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether two snapshots show the same array.

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// True if nodes, stylet and wall forces are equal: a view of one is a view of the other.
bool lookAlike(const haptics::Snapshot& one, const haptics::Snapshot& other);

}  // namespace perilymph::gui
