// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Hints in empty input fields.

class QLineEdit;
class QString;

namespace perilymph::gui {

/// Shows a hint in a field while it is empty, in italics and in the color of quiet text, so that it
/// does not look like a value.
void markPlaceholder(QLineEdit& field, const QString& hint);

}  // namespace perilymph::gui
