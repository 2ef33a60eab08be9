// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Formatting and parsing of numbers for users.

#include <QString>
#include <optional>

namespace perilymph::gui {

/// A number in the user's locale with fixed decimals; never "-0.0", no thousands separators.
QString numberText(double value, int decimals);

/// Parses a number in any locale: comma or point is the decimal sign, and there is no thousands
/// separator. Empty if it is not finite or has two decimal signs.
std::optional<double> typedNumber(const QString& text);

}  // namespace perilymph::gui
