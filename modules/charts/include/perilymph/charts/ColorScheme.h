#pragma once

// Dark or light: the colors of all charts of a program.

namespace perilymph::charts {

enum class ColorScheme { dark, light };

/// Charts made from now on have these colors; dark if nobody asks. Not while charts are drawn in
/// other threads.
void setColorScheme(ColorScheme look);

}  // namespace perilymph::charts
