#pragma once

// Numbers as people read them.

#include <QString>
#include <optional>

namespace perilymph::gui {

/// In the user's locale with a number of decimals; never "-0.0", no separators between thousands.
QString numberText(double value, int decimals);

/// A number as people type it: with their own decimal sign or with a point. None if it is no
/// finite number.
std::optional<double> typedNumber(const QString& text);

}  // namespace perilymph::gui
