// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A small table of values below heads that explain themselves.

#include <QString>
#include <span>
#include <utility>

class QTableWidget;

namespace perilymph::gui {

/// Sets a table of values up: small type, one row selected at a time, and a head with a tooltip for each column.
///
/// @param heads         Text and tooltip of each column.
/// @param rowHeight     Of each row [px].
/// @param headerHeight  Of the heads, whose words wrap [px].
void showValues(QTableWidget& table, std::span<const std::pair<QString, QString>> heads,
                int rowHeight, int headerHeight);

/// Makes columns as wide as their words, and at least as wide as given.
///
/// @param widths_px  At scale 1.
void fitColumns(QTableWidget& table, std::span<const int> widths_px);

}  // namespace perilymph::gui
