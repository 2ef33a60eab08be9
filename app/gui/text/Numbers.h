// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Formatting and parsing of numbers for users.

#include <QString>
#include <optional>

namespace perilymph::gui {

/// A number in the user's locale with fixed decimals; never "-0.0", no thousands separators.
QString numberText(double value, int decimals);

/// Decimals of forces: none, one where the largest is below 10 mN as it is shown.
int forceDecimals(double largest_mN);

/// An insertion's force that is kept: whole millinewtons, one decimal below 10 mN. Every page and report
/// shows it by this, so that one insertion has one number.
QString forceNumber(double force_mN);

/// A frequency in kHz with two decimals, one from 10 kHz: "0.35", "12.7". Every table of contacts has it.
QString kilohertzText(double frequency_Hz);

/// Parses a number in any locale: comma or point is the decimal sign, and there is no thousands
/// separator. Empty if it is not finite or has two decimal signs.
std::optional<double> typedNumber(const QString& text);

}  // namespace perilymph::gui
