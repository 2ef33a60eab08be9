// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace perilymph::gui {

/// A task with the time it will still take, once that can be told: "Reading the CT… about 12 s left".
///
/// @param fraction   What is done of it, 0 to 1.
/// @param elapsed_s  Since its begin [s].
QString taskText(const QString& task, double fraction, double elapsed_s);

}  // namespace perilymph::gui
