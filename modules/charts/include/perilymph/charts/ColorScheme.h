#pragma once

// Dark or light color scheme of all charts.

namespace perilymph::charts {

enum class ColorScheme { dark, light };

/// Sets the colors of charts made afterwards; dark by default. Not while other threads draw charts.
void setColorScheme(ColorScheme look);

}  // namespace perilymph::charts
