// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A figure for print: two axes, curves, bands and printed values, distinguishable without color.

#include <string>
#include <vector>

#include "perilymph/figures/Drawing.h"
#include "perilymph/foundation/Sentence.h"

namespace perilymph::figures {

/// An axis with equally spaced ticks.
struct FigureAxis {
  Sentence title;  ///< With its unit.
  double low = 0.0, high = 1.0, tick = 0.5;
  int decimals = 1;
};

/// A polyline through data points.
struct FigureCurve {
  Sentence label;  ///< Legend entry; none if empty.
  std::vector<double> x, y;
  Ink ink;
  double width = 1.5;
  double dash = 0.0;
};

/// An area between two curves.
struct FigureBand {
  Sentence label;
  std::vector<double> x, low, high;
  Ink ink;
};

enum class MarkerShape { disk, ring, square, diamond };

/// Single values with intervals, not connected.
struct FigureValues {
  Sentence label;
  std::vector<double> x, y, low, high;
  Ink ink;
  MarkerShape shape = MarkerShape::disk;
};

/// A horizontal line across the figure.
struct FigureLevel {
  Sentence label;  ///< Text at the line.
  double y = 0.0;
  Ink ink;
  double dash = 3.0;
};

/// A small text beside a point, on the side that has room.
struct FigureText {
  std::string text;
  double x = 0.0, y = 0.0;
  Ink ink;
};

struct Figure {
  Sentence title;
  FigureAxis x, y;
  std::vector<FigureBand> bands;
  std::vector<FigureLevel> levels;
  std::vector<FigureCurve> curves;
  std::vector<FigureValues> values;
  std::vector<FigureText> texts;
  std::vector<Sentence> notes;  ///< Lines below the figure.
};

namespace ink {
inline constexpr Ink black{{0, 0, 0}, 1.0};
inline constexpr Ink gray{{110, 110, 110}, 1.0};
inline constexpr Ink paleGrid{{225, 225, 225}, 1.0};
inline constexpr Ink blue{{0, 90, 160}, 1.0};
inline constexpr Ink vermilion{{190, 70, 0}, 1.0};
inline constexpr Ink green{{0, 120, 90}, 1.0};
inline constexpr Ink purple{{130, 60, 140}, 1.0};
/// A transparent tint of a color.
constexpr Ink tint(Ink full, double opacity) { return {full.rgb, opacity}; }
}  // namespace ink

/// Draws the figure on its page. Content outside the axes is clipped.
Drawing draw(const Figure& figure);

/// An axis that contains 0 and the given range, with about six ticks of 1, 2 or 5 times a power of
/// ten.
FigureAxis axisOver(Sentence title, double low, double high);

}  // namespace perilymph::figures
