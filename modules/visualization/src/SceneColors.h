// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Colors of the 3D view, as VTK takes them.

#include <array>
#include <cmath>

#include "perilymph/figures/Palette.h"

namespace perilymph::visualization {

/// Red, green, blue, opacity; each 0 to 255.
using Rgba = std::array<unsigned char, 4>;

/// The palette's colors of anatomy, array, forces and ground.
struct SceneColors {
  explicit SceneColors(const figures::Palette& palette);

  figures::ColorScheme scheme;
  Rgba bone, membrane, silicone, platinum, platinumRim, rib, steel, outline, arrow, frictionArrow,
      forceLow, forceHigh, lumen, solidBone, ground, groundLight, text, quietText, rupture, ghost;
};

/// The colors of a scheme: constants of the program.
const SceneColors& sceneColorsOf(figures::ColorScheme scheme);

inline Rgba withOpacity(Rgba color, double opacity)
{
  color[3] = static_cast<unsigned char>(std::lround(opacity * 255.0));
  return color;
}

inline Rgba rgbaOf(const figures::Ink& ink)
{
  return withOpacity({ink.rgb[0], ink.rgb[1], ink.rgb[2], 0}, ink.opacity);
}

}  // namespace perilymph::visualization
