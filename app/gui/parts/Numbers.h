#pragma once

// Numbers as people read them.

#include <QString>

namespace perilymph::gui {

/// In the user's locale with a number of decimals; never "-0.0", no separators between thousands.
QString numberText(double value, int decimals);

}  // namespace perilymph::gui
