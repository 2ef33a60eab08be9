// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Colors of the 3D view.

#include <array>
#include <cmath>

#include "perilymph/figures/Style.h"

namespace perilymph::visualization {

/// Red, green, blue, opacity; each 0 to 255.
using Rgba = std::array<unsigned char, 4>;

/// Colors of one scheme.
struct Palette {
  figures::ColorScheme scheme;
  Rgba bone, membrane, silicone, platinum, platinumRim, rib, steel, outline, arrow, frictionArrow,
      forceLow, forceHigh, ground, groundLight, text, quietText;
  Rgba rupture;  ///< The cochlear partition where it is torn.
  Rgba ghost;    ///< Another insertion's array; luminance 3:1 against silicone and ground.
};

/// The colors of a scheme: constants of the program.
const Palette& paletteOf(figures::ColorScheme scheme);

inline Rgba withOpacity(Rgba color, double opacity)
{
  color[3] = static_cast<unsigned char>(std::lround(opacity * 255.0));
  return color;
}

}  // namespace perilymph::visualization
