#pragma once

// Numbers as people read them.

#include <QString>
#include <optional>

namespace perilymph::gui {

/// In the user's locale with a number of decimals; never "-0.0", no separators between thousands.
QString numberText(double value, int decimals);

/// A number as people type it in any locale: a comma or a point is the decimal sign, and nothing
/// parts thousands. None if it is no finite number or has two such signs.
std::optional<double> typedNumber(const QString& text);

}  // namespace perilymph::gui
