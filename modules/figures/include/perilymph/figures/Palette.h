// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The colors of everything drawn on screen, widgets, charts and 3D view: dark and light.

#include "perilymph/figures/Drawing.h"

namespace perilymph::figures {

enum class ColorScheme { dark, light };

/// The colors of one scheme. Text has a contrast of 4.5:1 or more on each of its backgrounds.
struct Palette {
  ColorScheme scheme;

  // --- Grounds ---
  Ink ground;   ///< Views, charts and input fields.
  Ink panel;    ///< The area around them.
  Ink raised;   ///< Buttons.
  Ink pressed;  ///< Draggable elements.
  Ink banner;   ///< Background of error messages.

  // --- Lines ---
  Ink line;
  Ink border;  ///< Edges of fields and buttons; 3:1 on the background.
  Ink ahead;   ///< Remaining part of a progress line; 3:1 on the background.
  Ink grid;    ///< Grid of charts.
  Ink zero;    ///< Zero line of charts.

  // --- Text and marks ---
  Ink text, quiet;
  Ink accent;             ///< The current insertion, and the primary action.
  Ink accentHover;        ///< The same under the mouse.
  Ink onAccent;           ///< Text on both.
  Ink blue;               ///< Other insertions: reference run, comparison.
  Ink orange;             ///< Marks of charts, forces of the 3D view.
  Ink pink;               ///< The fourth of compared insertions.
  Ink warning;            ///< Always together with text.
  Ink onWarning;          ///< Text on it.
  Ink alarm;              ///< A status light, always together with text.
  Ink stop, stopPressed;  ///< The stop button.
  Ink onStop;             ///< Text on it.

  // --- Anatomy and array ---
  Ink bone, lumen, membrane;
  Ink rupture;             ///< The cochlear partition where it is torn.
  Ink silicone, platinum;  ///< The array in flat drawings.
  Ink outline;

  // --- The same under the lights of the 3D view ---
  Ink litSilicone, litPlatinum, platinumRim, rib, steel;
  Ink forceLow, forceHigh;  ///< Ends of the scale of force on the wall.
  Ink sceneGround, sceneGroundLight;
  Ink ghost;  ///< Another insertion's array; luminance 3:1 against silicone and ground.
};

/// The colors of a scheme: constants of the program.
const Palette& paletteOf(ColorScheme scheme);

/// The ink with another opacity.
constexpr Ink faded(Ink ink, double opacity)
{
  ink.opacity = opacity;
  return ink;
}

/// Size of labels on screen at pixel ratio 1 [px].
inline constexpr int labelSize = 11;

}  // namespace perilymph::figures
