#pragma once

// Dark or light: the colors of all pictures of a program.

namespace perilymph::visualization {

enum class ColorScheme { dark, light };

/// Scenes made from now on have these colors; dark if nobody asks. Not while one is drawn in
/// another thread.
void setColorScheme(ColorScheme look);

}  // namespace perilymph::visualization
