#pragma once

// Dark or light color scheme of all pictures.

namespace perilymph::visualization {

enum class ColorScheme { dark, light };

/// Sets the colors of scenes made afterwards; dark by default. Not while another thread draws a
/// scene.
void setColorScheme(ColorScheme look);

}  // namespace perilymph::visualization
