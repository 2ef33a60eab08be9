// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Titles of what the insertion page shows.

#include <QString>

namespace perilymph::gui {

class InsertPage;

/// Title of the setup on the insertion page; empty if it was not used yet.
QString currentWork(const InsertPage& insertion);

/// "P-017: FLEX28 — Perilymph". The program's name is last: a desktop that adds it finds it there.
QString windowTitleOf(const InsertPage& insertion);

}  // namespace perilymph::gui
