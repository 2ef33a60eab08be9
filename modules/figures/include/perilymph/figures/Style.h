// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Color schemes of everything drawn on screen: dark and light.

#include "perilymph/figures/Drawing.h"

namespace perilymph::figures {

enum class ColorScheme { dark, light };

/// Colors of one scheme.
struct SchemeInks {
  Ink panel, ground, grid, zero, text, quiet, accent, blue, orange, bone, lumen, membrane, silicone,
      platinum, rupture;
};

/// The colors of a scheme; constant.
const SchemeInks& inksOf(ColorScheme scheme);

/// The ink with another opacity.
constexpr Ink faded(Ink ink, double opacity)
{
  ink.opacity = opacity;
  return ink;
}

/// Size of labels on screen at pixel ratio 1 [px].
inline constexpr int labelSize = 11;

}  // namespace perilymph::figures
