// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A table that is read in whole rows.

class QTableView;

namespace perilymph::gui {

/// Sets a table up for whole rows that are selected, not edited: no grid, no row headers, Tab leaves
/// the table, rows scroll by pixels.
///
/// @param rowHeight  Of each row [px].
void showInRows(QTableView& table, int rowHeight);

}  // namespace perilymph::gui
