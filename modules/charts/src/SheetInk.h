#pragma once

// Colors of the flat views, in both schemes.

#include "perilymph/analysis/Drawing.h"
#include "perilymph/charts/ColorScheme.h"

namespace perilymph::charts::ink {

struct Inks {
  analysis::Ink panel, ground, grid, zero, text, quiet, accent, orange, bone, lumen, membrane,
      silicone, platinum;
};

/// The colors of the current scheme. The object is the same when the scheme changes.
const Inks& shown();
/// Called only by charts::setColorScheme.
void show(ColorScheme look);

inline const analysis::Ink& panel = shown().panel;
inline const analysis::Ink& ground = shown().ground;
inline const analysis::Ink& grid = shown().grid;
inline const analysis::Ink& zero = shown().zero;
inline const analysis::Ink& text = shown().text;
inline const analysis::Ink& quiet = shown().quiet;
inline const analysis::Ink& accent = shown().accent;
inline const analysis::Ink& orange = shown().orange;
inline const analysis::Ink& bone = shown().bone;
inline const analysis::Ink& lumen = shown().lumen;
inline const analysis::Ink& membrane = shown().membrane;
inline const analysis::Ink& silicone = shown().silicone;
inline const analysis::Ink& platinum = shown().platinum;

constexpr analysis::Ink faded(analysis::Ink ink, double opacity)
{
  ink.opacity = opacity;
  return ink;
}

}  // namespace perilymph::charts::ink
