#pragma once

// Colors and sizes of the charts.

#include <vtkColor.h>

#include "perilymph/charts/ColorScheme.h"

namespace perilymph::charts::style {

struct Colors {
  vtkColor4ub panel, ground, gridLine, zeroLine, text, quietText, accent, blue, orange;
};

/// The colors of the current scheme. The object is the same when the scheme changes.
const Colors& shown();

inline const vtkColor4ub& panel = shown().panel;
inline const vtkColor4ub& ground = shown().ground;
inline const vtkColor4ub& gridLine = shown().gridLine;
inline const vtkColor4ub& zeroLine = shown().zeroLine;
inline const vtkColor4ub& text = shown().text;
inline const vtkColor4ub& quietText = shown().quietText;
inline const vtkColor4ub& accent = shown().accent;
inline const vtkColor4ub& blue = shown().blue;
inline const vtkColor4ub& orange = shown().orange;

inline constexpr int labelSize = 11;  ///< Pixels at pixel ratio 1.
inline constexpr float lineWidth = 2.0f;
inline constexpr float thinWidth = 1.2f;

}  // namespace perilymph::charts::style
